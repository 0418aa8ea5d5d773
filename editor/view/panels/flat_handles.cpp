// Handles over the 2D view, which set values of the node by a drag (document/uv_handles.h).
#include <algorithm>
#include <cmath>

#include "editor/model/document/uv_handles.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/preview_parts.h"

namespace wrinkle::editor {
namespace {

constexpr float handle_side = 18, mark_radius = 5;

ImVec2 on_screen(const FlatPanel& panel, glm::dvec2 at) {
    return {panel.x_of(at.x), panel.y_of(at.y)};
}

const UvHandle* find(const std::vector<UvHandle>& handles, std::string_view port) {
    for (const UvHandle& handle : handles)
        if (handle.port == port) return &handle;
    return nullptr;
}

// The line from a to b, the box, the circle of the radius and the arm of the angle.
void draw_guides(const FlatPanel& panel, const std::vector<UvHandle>& handles,
                 const std::vector<glm::dvec2>& box) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = theme::with_alpha(theme::accent, 0.8F);
    for (size_t i = 0; i < box.size(); ++i)
        list.AddLine(on_screen(panel, box[i]), on_screen(panel, box[(i + 1) % box.size()]), color);
    const UvHandle *a = find(handles, "a"), *b = find(handles, "b");
    if (a && b) list.AddLine(on_screen(panel, a->at), on_screen(panel, b->at), color);
    const UvHandle* center = find(handles, "center");
    if (!center) return;
    const ImVec2 middle = on_screen(panel, center->at);
    for (const UvHandle& handle : handles) {
        const ImVec2 at = on_screen(panel, handle.at), arm = at - middle;
        if (handle.kind == UvHandle::Kind::angle) list.AddLine(middle, at, color);
        if (handle.kind == UvHandle::Kind::distance)
            list.AddCircle(middle, std::max(std::hypot(arm.x, arm.y), 1.0F), color);
    }
}

void draw_mark(ImVec2 at, bool bright) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircleFilled(at, mark_radius, bright ? theme::accent : theme::text);
    list.AddCircle(at, mark_radius, theme::canvas, 0, 1.5F);
}

// Escape ends the drag and restores the value, while the button is still down.
void drag_handle(State& state, const FlatPanel& panel, const Node& node, const NodeType& type,
                 const UvHandle& handle) {
    FlatFeed& flat = state.flat;
    if (ImGui::IsItemActivated()) {
        flat.handle = handle.port;
        flat.merge = "handle " + std::to_string(state.history.serial());
    }
    if (flat.handle != handle.port) return;
    note_held(state);
    if (is_pressed(ImGuiKey_Escape, false)) state.history.cancel(flat.merge);
    if (is_pressed(ImGuiKey_Escape, false) || !ImGui::IsItemActive()) return flat.handle.clear();
    if (!ImGui::IsMouseDragging(ImGuiMouseButton_Left)) return;
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 to(panel.u_at(io.MousePos.x), panel.v_at(io.MousePos.y));
    state.commit(node.id + ": " + flat.handle,
                 with_handle_at(state.document(), node, type, handle.port, to, io.KeyCtrl),
                 flat.merge);
}

}  // namespace

void use_flat_handles(State& state, const FlatPanel& panel) {
    const std::string id = flat_node(state);
    const NodePtr* found = state.document().nodes.find(id);
    const NodeType* type = state.type_of(id);
    if (!found || !type) return;
    const NodePtr node = *found;  // edits replace it
    const std::vector<UvHandle> handles = uv_handles(*node, *type);
    draw_guides(panel, handles, box_of_handles(*node, *type));
    for (const UvHandle& handle : handles) {
        const ImVec2 at = on_screen(panel, handle.at);
        if (!panel.contains(at) && state.flat.handle != handle.port) continue;
        const ImVec2 side(handle_side, handle_side);
        ImGui::SetCursorScreenPos(at - side * 0.5F);
        const Area area = area_button(state, "handle:" + std::string(handle.port), side);
        const bool active = ImGui::IsItemActive();
        drag_handle(state, panel, *node, *type, handle);
        draw_mark(at, active || area.hovered);
        if (area.hovered && !active) show_tooltip(last_item(), std::string(handle.port));
    }
}

}  // namespace wrinkle::editor

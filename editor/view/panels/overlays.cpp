// Overlays on the canvas: breadcrumb of open graphs, zoom, minimap.
#include <algorithm>

#include "editor/model/document/levels.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/commands/commands.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/regions.h"

namespace wrinkle::editor {
namespace {

constexpr float margin = 16, tall = 28, crumb_gap = 24;

WindowStyle overlay_style() {
    return {.ground = theme::bar, .border = theme::border, .rounding = 5, .flags = overlay_flags};
}

// One open file of the breadcrumb, or "..." for several.
struct Crumb {
    static constexpr size_t gap = ~size_t{0};
    size_t depth = 0;  // index into Session::parent_graphs; its size: the graph on the canvas
    std::string text;
    float width = 0;
};

float width_of(const std::vector<Crumb>& crumbs) {
    float width = 0;
    for (const Crumb& crumb : crumbs)
        width += crumb.width + crumb_gap;
    return width;
}

// Returns the crumbs that fit; drops those after the outermost file first, the innermost stays.
std::vector<Crumb> find_crumbs(const State& state, float room) {
    ImFont* font = state.fonts.regular(16);
    std::vector<std::string> files = open_files(state);
    std::vector<Crumb> crumbs;
    for (size_t i = 0; i < files.size(); ++i) {
        const bool dirty = i < state.parent_graphs.size() && state.parent_graphs[i].dirty();
        const float most = std::max(room / (files.size() > 1 ? 2 : 1) - 48, 60.0F);
        const std::string text = fitting(font, 16, files[i], most) + (dirty ? " *" : "");
        crumbs.push_back({i, text, text_width(font, 16, text)});
    }
    if (width_of(crumbs) <= room || crumbs.size() < 3) return crumbs;
    crumbs[1] = {Crumb::gap, "...", text_width(font, 16, "...")};
    while (width_of(crumbs) > room && crumbs.size() > 3)
        crumbs.erase(crumbs.begin() + 2);
    return crumbs;
}

// Draws the open files from the outermost to the one on the canvas; a click returns to that file.
void draw_crumbs(State& state) {
    const View& view = state.view;
    ImFont* font = state.fonts.regular(16);
    std::vector<Crumb> crumbs = find_crumbs(state, view.extent.x - 2 * margin);
    if (crumbs.size() == 1)
        crumbs.push_back({Crumb::gap, "Main graph", text_width(font, 16, "Main graph")});
    const float width = width_of(crumbs);
    const ImVec2 low = view.corner + ImVec2(margin, margin);
    const FixedWindow window("##crumbs", low, {width, tall}, overlay_style());
    name_area(state, "crumbs", low, low + ImVec2(width, tall));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImVec2 at = low + ImVec2(12, 6);
    std::optional<size_t> pressed;
    for (const Crumb& crumb : crumbs) {
        const bool leads = crumb.depth < state.parent_graphs.size();
        const bool here = crumb.depth == state.parent_graphs.size();
        if (leads) {
            ImGui::SetCursorScreenPos(at - ImVec2(6, 5));
            const Area area = area_button(state, "crumb:" + std::to_string(crumb.depth),
                                          {crumb.width + 12, tall - 2});
            if (area.hovered) list.AddRectFilled(area.low, area.high, theme::accent_soft, 4);
            if (area.pressed) pressed = crumb.depth;
        }
        draw_text(list, font, 16, at, here ? theme::text : theme::text_dim, crumb.text);
        at.x += crumb.width + crumb_gap;
        if (&crumb != &crumbs.back())
            draw_icon(list, "into", at + ImVec2(-crumb_gap / 2, 8), theme::text_dim);
    }
    if (pressed) request_action(state, {PendingAction::Kind::leave, {}, *pressed});
}

// Draws a button that runs a command, with its icon centered `icon` pixels from the left.
void draw_part(State& state, const char* id, ImVec2 at, float width, float icon) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::SetCursorScreenPos(at);
    const Area area = area_button(state, std::string("canvas:") + id, {width, tall});
    if (area.hovered)
        list.AddRectFilled(area.low + ImVec2(1, 1), area.high - ImVec2(1, 1), theme::accent_soft,
                           4);
    if (area.pressed) run_command(state, id);
    draw_icon(list, id, at + ImVec2(icon, 14), theme::text_dim);
}

void draw_zoom(State& state) {
    const View& view = state.view;
    const float y = view.corner.y + view.extent.y - margin - tall;
    const ImVec2 at(view.corner.x + margin, y);
    const FixedWindow window("##zoom", at, {188, tall}, overlay_style());
    ImFont* font = state.fonts.regular(16);
    const auto write = [&](float x, const std::string& text) {
        draw_text(*ImGui::GetWindowDrawList(), font, 16, at + ImVec2(x, 6), theme::text, text);
    };
    draw_part(state, "fit", at, 64, 18);
    write(33, "Fit");
    draw_part(state, "zoom-out", at + ImVec2(68, 0), 32, 16);
    const std::string zoom = percent(view.zoom);
    write(126 - text_width(font, 16, zoom) / 2, zoom);
    draw_part(state, "zoom-in", at + ImVec2(152, 0), 32, 16);
}

struct Map {
    ImVec2 origin;  // screen position of the canvas origin
    float scale;
    ImVec2 at(ImVec2 canvas) const { return origin + canvas * scale; }
};

Map fit_map(const Layout& layout, const Extent& area) {
    const Extent& all = layout.bounds;
    const ImVec2 size = all.high - all.low, room = area.high - area.low - ImVec2(16, 16);
    const float scale =
        std::min({room.x / std::max(size.x, 1.0F), room.y / std::max(size.y, 1.0F), 0.12F});
    const ImVec2 middle = (all.low + all.high) * 0.5F;
    return {(area.low + area.high) * 0.5F - middle * scale, scale};
}

void draw_cards(const State& state, const Map& map) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool any = !state.view.selected.empty();
    for (const Card& card : state.layout.cards) {
        const ImVec2 low = map.at(card.at), size = card.size * map.scale;
        const bool selected = any && state.view.selected.contains(card.id);
        list.AddRectFilled(low, low + ImVec2(std::max(size.x, 1.5F), std::max(size.y, 1.5F)),
                           selected ? theme::accent : theme::control);
    }
    for (const Diagnostic& problem : state.built.problems.list()) {
        const std::string_view path = problem.node;
        const Card* card = state.layout.find(path.substr(0, path.find('/')));
        if (!card) continue;
        const ImVec2 low = map.at(card->at), size = card->size * map.scale;
        list.AddRectFilled(low, low + ImVec2(std::max(size.x, 3.0F), std::max(size.y, 3.0F)),
                           problem.severity == Severity::error ? theme::error : theme::warn);
    }
}

// A click or drag on the minimap centers the canvas at that position.
void draw_minimap(State& state) {
    View& view = state.view;
    const ImVec2 at = minimap_area(view).low, map_size = minimap_area(view).high - at;
    const FixedWindow window("##minimap", at, map_size, overlay_style());
    const Map map = fit_map(state.layout, minimap_area(view));
    draw_cards(state, map);
    const ImVec2 low = map.at(to_canvas(view, view.corner));
    const ImVec2 high = map.at(to_canvas(view, view.corner + view.extent));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(at + ImVec2(1, 1), at + map_size - ImVec2(1, 1), true);
    list.AddRect(low, high, theme::text_dim, 2);
    list.PopClipRect();
    ImGui::SetCursorScreenPos(at);
    area_button(state, "minimap", map_size);
    if (!ImGui::IsItemActive() && !ImGui::IsItemDeactivated()) return;
    if (!ImGui::IsMousePosValid()) return;  // the pointer left the window
    const ImVec2 canvas = (ImGui::GetIO().MousePos - map.origin) * (1 / map.scale);
    view.pan = view.extent * 0.5F - canvas * view.zoom;
}

}  // namespace

void draw_overlays(State& state) {
    const View& view = state.view;
    if (is_at_start(state) || regions_of(state).canvas.size.x <= 0) return;
    if (view.extent.x < 260 || view.extent.y < 140) return;
    draw_crumbs(state);
    draw_zoom(state);
    if (!minimap_area(view).empty() && !state.document().nodes.empty()) draw_minimap(state);
}

}  // namespace wrinkle::editor

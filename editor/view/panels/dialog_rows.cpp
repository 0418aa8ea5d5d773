#include "editor/view/panels/dialog_rows.h"

#include "editor/view/look/draw.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/browser.h"
#include "editor/view/panels/preview_parts.h"
#include "mesh/shapes.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;

void begin_control(const Fonts& fonts, const char* label, const char* tip, float x) {
    if (x > 0) ImGui::SameLine(x);
    const ImVec2 size(label_wide, dialog_row_tall - ImGui::GetStyle().ItemSpacing.y);
    ImGui::Dummy(size);
    const About area = last_item();
    draw_text(*ImGui::GetWindowDrawList(), fonts.regular(16), 16, area.low + ImVec2(0, 4),
              theme::text_dim, label);
    if (tip && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem))
        show_tooltip(area, tip);
    ImGui::SameLine(0, 0);
}

void choose_mesh(State& state, const std::string& prefix, std::string& mesh, float wide,
                 Browser::Purpose purpose) {
    std::vector<Item> items;
    for (const Shape& shape : shapes())
        items.push_back(
            {mesh_label(std::string(shape.name)), prefix + ":mesh:" + std::string(shape.name)});
    const std::string& shown = state.view.preview_view.mesh;
    const size_t shapes_end = items.size();
    // A mesh file follows the shapes: the preview's, or the chosen one.
    for (const std::string& each : {shown, mesh})
        if (!is_shape(each) && items.size() == shapes_end)
            items.push_back({mesh_label(each), prefix + ":mesh:file"});
    items.push_back({"Choose a file...", prefix + ":mesh:browse"});
    const int picked = choose(state, prefix + ":mesh", mesh_label(mesh), items, wide);
    if (picked < 0) return;
    const auto index = static_cast<size_t>(picked);
    if (index < shapes_end)
        mesh = shapes()[index].name;
    else if (index + 1 < items.size())
        mesh = is_shape(shown) ? mesh : shown;
    else
        browse(state, purpose, is_shape(mesh) ? state.folder() / "x" : fs::path(mesh));
}

}  // namespace wrinkle::editor

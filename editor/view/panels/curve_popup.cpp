// Editor of a curve, in the popup over its card: the curve, a handle for each point, and the
// position and value of the selected point.
#include <imgui.h>

#include <algorithm>

#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/knot_popup.h"
#include "editor/view/preview/knot_values.h"

namespace wrinkle::editor {
namespace {

constexpr float plot_wide = 320, plot_tall = 220, handle_radius = 6;

struct CurveEditor : KnotEditor {
    std::vector<glm::dvec2> points = points_of(*node, *card.type);
    Range range = range_of_curve(card.values, points);
    glm::dvec2 point() const { return points[selected()]; }

    ImVec2 on_screen(ImVec2 plot, glm::dvec2 point) const {
        const double up = (point.y - range.least) / (range.most - range.least);
        return plot + ImVec2(static_cast<float>(point.x) * plot_wide,
                             plot_tall * (1 - static_cast<float>(up)));
    }
    // Returns the point at the pointer; of a position from 0 to 1 and a value in the range.
    glm::dvec2 pointed(ImVec2 plot) const {
        const ImVec2 at = ImGui::GetIO().MousePos - plot;
        const auto x = static_cast<double>(at.x / plot_wide);
        const auto up = static_cast<double>(1 - at.y / plot_tall);
        return {std::clamp(x, 0.0, 1.0),
                range.least + std::clamp(up, 0.0, 1.0) * (range.most - range.least)};
    }
};

void add_point(const CurveEditor& curve, glm::dvec2 point) {
    if (curve.is_full()) return;
    curve.commit(with_point(curve.state.document(), *curve.node, *curve.card.type, point));
    curve.select(index_after(positions_of(curve.points), point.x));
}

// Adds a point of the curve in the middle between the selected one and the next, or the one before
// the last.
void add_beside(const CurveEditor& curve) {
    const size_t right = std::min(curve.selected() + 1, curve.count() - 1);
    const double x = (curve.points[right - 1].x + curve.points[right].x) / 2;
    const std::vector<double>& values = curve.card.values;
    const auto last = static_cast<double>(values.size()) - 1;
    const double y =
        values.empty() ? 0 : values[static_cast<size_t>(std::clamp(x, 0.0, 1.0) * last)];
    add_point(curve, {x, y});
}

void move_selected(const CurveEditor& curve, glm::dvec2 to) {
    if (!curve.is_on_wire("point"))
        curve.commit(with_point_at(curve.state.document(), *curve.node, *curve.card.type,
                                   curve.selected(), to));
}

void use_handle(const CurveEditor& curve, size_t point, ImVec2 plot) {
    const ImVec2 radius(handle_radius, handle_radius);
    ImGui::SetCursorScreenPos(curve.on_screen(plot, curve.points[point]) - radius);
    area_button(curve.state, "curve:point" + std::to_string(point + 1), radius * 2);
    if (ImGui::IsItemActivated()) curve.select(point);
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left))
        move_selected(curve, curve.pointed(plot));
}

void draw_grid(ImDrawList& list, ImVec2 plot) {
    const ImVec2 end = plot + ImVec2(plot_wide, plot_tall);
    list.AddRectFilled(plot, end, theme::field);
    for (int i = 1; i < 4; ++i) {
        const float part = static_cast<float>(i) / 4;
        const float x = plot.x + plot_wide * part, y = plot.y + plot_tall * part;
        list.AddLine({x, plot.y}, {x, end.y}, theme::border);
        list.AddLine({plot.x, y}, {end.x, y}, theme::border);
    }
    list.AddRect(plot, end, theme::control);
}

void draw_plot(const CurveEditor& curve) {
    const ImVec2 plot = ImGui::GetCursorScreenPos() + ImVec2(handle_radius, 0);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_grid(list, plot);
    draw_curve_values(list, plot, plot + ImVec2(plot_wide, plot_tall), curve.card.values,
                      curve.range, theme::accent);
    // Of handles at one position the first one takes the press.
    use_handle(curve, curve.selected(), plot);
    for (size_t i = 0; i < curve.points.size(); ++i)
        if (i != curve.selected()) use_handle(curve, i, plot);
    for (size_t i = 0; i < curve.points.size(); ++i) {
        const ImVec2 at = curve.on_screen(plot, curve.points[i]);
        list.AddCircleFilled(at, handle_radius,
                             i == curve.selected() ? theme::accent : theme::text);
        list.AddCircle(at, handle_radius, theme::panel, 0, 1.5F);
    }
    ImGui::SetCursorScreenPos(plot);
    const Area area = area_button(curve.state, "curve:plot", {plot_wide, plot_tall});
    if (area.pressed) add_point(curve, curve.pointed(plot));
    ImGui::Dummy({0, 4});
}

void draw_numbers(const CurveEditor& curve) {
    float numbers[] = {static_cast<float>(curve.point().x), static_cast<float>(curve.point().y)};
    ImGui::SetNextItemWidth(132);
    const bool moved = ImGui::DragFloat2("##point", numbers, 0.002F, 0, 0, "%.3f");
    name_item(curve.state, "curve:point");
    note_held(curve.state);
    if (moved) move_selected(curve, {numbers[0], numbers[1]});
    ImGui::SameLine();
}

}  // namespace

bool draw_curve(State& state) {
    const std::optional<KnotEditor> editor = edit_knots(state, curve_ports);
    if (!editor) return true;
    const CurveEditor curve{*editor};
    const KnotKeys keys = read_knot_keys(curve);
    if (keys.move.x != 0 || keys.move.y != 0)
        move_selected(curve, {curve.point().x + static_cast<double>(keys.move.x) * knot_step,
                              curve.point().y + static_cast<double>(keys.move.y) * knot_step});
    draw_plot(curve);
    draw_numbers(curve);
    if (draw_knot_buttons(curve, "Point", "curve") || keys.add) add_beside(curve);
    return end_knots(state);
}

}  // namespace wrinkle::editor

// Editor of a color ramp, in the popup over its card: the colors, a handle for each stop, and the
// position and color of the selected stop.
#include <imgui.h>

#include <algorithm>

#include "base/srgb.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/knot_popup.h"
#include "editor/view/preview/knot_values.h"

namespace wrinkle::editor {
namespace {

constexpr float ramp_wide = 320, ramp_tall = 28, handle_wide = 14, handle_tall = 18;

struct RampEditor : KnotEditor {
    std::vector<RampStop> stops = stops_of(*node, *card.type);
    double position() const { return stops[selected()].position; }
};

// Returns the color of the ramp at a position, linear.
std::array<double, 3> color_at(const RampEditor& ramp, double position) {
    const std::vector<glm::dvec3>& strip = ramp.card.strip;
    std::array<double, 3> color{};
    if (strip.empty()) return color;
    const auto last = static_cast<double>(strip.size() - 1);
    const auto column = static_cast<size_t>(std::clamp(position, 0.0, 1.0) * last + 0.5);
    for (size_t i = 0; i < 3; ++i)
        color[i] = linear_from_srgb(strip[column][static_cast<int>(i)]);
    return color;
}

void add_stop(const RampEditor& ramp, double position) {
    if (ramp.is_full()) return;
    ramp.commit(with_stop(ramp.state.document(), *ramp.node, *ramp.card.type,
                          {position, color_at(ramp, position)}));
    ramp.select(index_after(positions_of(ramp.stops), position));
}

// Adds a stop in the middle between the selected one and the next, or the one before the last.
void add_beside(const RampEditor& ramp) {
    const size_t right = std::min(ramp.selected() + 1, ramp.count() - 1);
    add_stop(ramp, (ramp.stops[right - 1].position + ramp.stops[right].position) / 2);
}

void move_selected(const RampEditor& ramp, double position) {
    if (!ramp.is_on_wire("position"))
        ramp.commit(with_stop_at(ramp.state.document(), *ramp.node, *ramp.card.type,
                                 ramp.selected(), position));
}

ImVec2 handle_at(const RampEditor& ramp, size_t stop, ImVec2 strip) {
    const auto x = static_cast<float>(ramp.stops[stop].position) * ramp_wide;
    return strip + ImVec2(x - handle_wide / 2, ramp_tall + 4);
}

void use_handle(const RampEditor& ramp, size_t stop, ImVec2 strip) {
    ImGui::SetCursorScreenPos(handle_at(ramp, stop, strip));
    area_button(ramp.state, "ramp:stop" + std::to_string(stop + 1), {handle_wide, handle_tall});
    if (ImGui::IsItemActivated()) ramp.select(stop);
    const float at = (ImGui::GetIO().MousePos.x - strip.x) / ramp_wide;
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left))
        move_selected(ramp, static_cast<double>(at));
}

void draw_handle(const RampEditor& ramp, size_t stop, ImVec2 low) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::array<int, 3> shown{};
    for (size_t i = 0; i < 3; ++i)
        shown[i] = static_cast<int>(
            srgb_from_linear(std::clamp(ramp.stops[stop].color[i], 0.0, 1.0)) * 255 + 0.5);
    const ImVec2 shape[] = {low + ImVec2(handle_wide / 2, -4), low + ImVec2(handle_wide, 4),
                            low + ImVec2(handle_wide, handle_tall), low + ImVec2(0, handle_tall),
                            low + ImVec2(0, 4)};
    list.AddConvexPolyFilled(shape, 5, IM_COL32(shown[0], shown[1], shown[2], 255));
    const bool selected = stop == ramp.selected();
    list.AddPolyline(shape, 5, selected ? theme::accent : theme::control, ImDrawFlags_Closed,
                     selected ? 2.5F : 1.5F);
}

void draw_handles(const RampEditor& ramp, ImVec2 strip) {
    // Of handles at one position the first one takes the press, and the last one is in sight.
    const size_t selected = ramp.selected();
    use_handle(ramp, selected, strip);
    for (size_t i = 0; i < ramp.stops.size(); ++i)
        if (i != selected) use_handle(ramp, i, strip);
    for (size_t i = 0; i < ramp.stops.size(); ++i)
        if (i != selected) draw_handle(ramp, i, handle_at(ramp, i, strip));
    draw_handle(ramp, selected, handle_at(ramp, selected, strip));
}

void draw_strip(const RampEditor& ramp) {
    const ImVec2 at = ImGui::GetCursorScreenPos() + ImVec2(handle_wide / 2, 0);
    ImGui::SetCursorScreenPos(at);
    const Area strip = area_button(ramp.state, "ramp:strip", {ramp_wide, ramp_tall});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_ramp_colors(list, strip.low, strip.high, ramp.card.strip);
    list.AddRect(strip.low, strip.high, theme::control);
    draw_handles(ramp, at);
    ImGui::SetCursorScreenPos(at + ImVec2(-handle_wide / 2, ramp_tall + handle_tall + 12));
    const float x = (ImGui::GetIO().MousePos.x - at.x) / ramp_wide;
    if (strip.pressed) add_stop(ramp, std::clamp(static_cast<double>(x), 0.0, 1.0));
}

void draw_position(const RampEditor& ramp) {
    auto position = static_cast<float>(ramp.position());
    ImGui::SetNextItemWidth(72);
    const bool moved = ImGui::DragFloat("##position", &position, 0.002F, 0, 1, "%.3f");
    name_item(ramp.state, "ramp:position");
    note_held(ramp.state);
    if (moved) move_selected(ramp, static_cast<double>(position));
    ImGui::SameLine();
}

void draw_stop_color(const RampEditor& ramp) {
    if (ramp.has_wire("color")) return ImGui::TextDisabled("The color is set by a wire.");
    std::array<float, 3> color{};
    std::ranges::transform(ramp.stops[ramp.selected()].color, color.begin(),
                           [](double each) { return static_cast<float>(each); });
    const bool changed = pick_color(ramp.state, "ramp:color", color);
    if (changed)
        ramp.commit(with_stop_color(ramp.state.document(), *ramp.node, *ramp.card.type,
                                    ramp.selected(), {color[0], color[1], color[2]}));
}

}  // namespace

bool draw_ramp(State& state) {
    const std::optional<KnotEditor> editor = edit_knots(state, ramp_ports);
    if (!editor) return true;
    const RampEditor ramp{*editor};
    const KnotKeys keys = read_knot_keys(ramp);
    if (keys.move.x != 0)
        move_selected(ramp, ramp.position() + static_cast<double>(keys.move.x) * knot_step);
    draw_strip(ramp);
    draw_position(ramp);
    if (draw_knot_buttons(ramp, "Stop", "ramp") || keys.add) add_beside(ramp);
    draw_stop_color(ramp);
    return end_knots(state);
}

}  // namespace wrinkle::editor

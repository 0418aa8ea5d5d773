// Editor of a color ramp, in the popup over its card: the strip, a handle for each stop, and the
// position and color of the selected stop. Each gesture is one undo step.
#include <imgui.h>

#include <algorithm>

#include "base/srgb.h"
#include "editor/model/document/ramp.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"
#include "editor/view/preview/ramp_strip.h"

namespace wrinkle::editor {
namespace {

constexpr float ramp_wide = 320, ramp_tall = 28, handle_wide = 14, handle_tall = 18;
constexpr double key_step = 0.01;

// The ramp that the popup edits.
struct Edited {
    State& state;
    const Node& node;
    const NodeType& type;
    std::vector<RampStop> stops;
    std::vector<glm::dvec3> strip;

    size_t selected() const { return static_cast<size_t>(state.popup.lane); }
    void select(size_t stop) const { state.popup.lane = static_cast<int>(stop); }
    void commit(Document document) const {
        state.commit(node.id + ": color ramp", std::move(document), state.popup.merge);
    }
};

bool is_on_wire(const Edited& ramp, const std::string& port) {
    const Input* input = ramp.node.find(port);
    return input && input->kind == Input::Kind::link;
}

// The color of the strip at a position, linear.
std::array<double, 3> color_at(const Edited& ramp, double position) {
    std::array<double, 3> color{};
    if (ramp.strip.empty()) return color;
    const auto last = static_cast<double>(ramp.strip.size() - 1);
    const auto column = static_cast<size_t>(std::clamp(position, 0.0, 1.0) * last + 0.5);
    for (size_t i = 0; i < 3; ++i)
        color[i] = linear_from_srgb(ramp.strip[column][static_cast<int>(i)]);
    return color;
}

void add_stop(const Edited& ramp, double position) {
    if (ramp.stops.size() >= max_stops(ramp.type)) {
        ramp.state.status =
            "A ramp has at most " + std::to_string(max_stops(ramp.type)) + " stops.";
        return;
    }
    ramp.commit(with_stop(ramp.state.document(), ramp.node, ramp.type,
                          {position, color_at(ramp, position)}));
    ramp.select(index_of_stop(ramp.stops, position));
}

// Adds a stop in the middle between the selected one and the next, or the one before the last.
void add_beside(const Edited& ramp) {
    const size_t right = std::min(ramp.selected() + 1, ramp.stops.size() - 1);
    add_stop(ramp, (ramp.stops[right - 1].position + ramp.stops[right].position) / 2);
}

void remove_selected(const Edited& ramp) {
    ramp.commit(without_stop(ramp.state.document(), ramp.node, ramp.type, ramp.selected()));
    ramp.select(ramp.selected() > 0 ? ramp.selected() - 1 : 0);
}

void move_selected(const Edited& ramp, double position) {
    const std::string port = position_port(ramp.selected());
    if (is_on_wire(ramp, port)) {
        ramp.state.status = port + " is set by a wire.";
        return;
    }
    ramp.commit(
        with_stop_at(ramp.state.document(), ramp.node, ramp.type, ramp.selected(), position));
}

void draw_handle(const Edited& ramp, size_t stop, ImVec2 low) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::array<int, 3> shown{};
    for (size_t i = 0; i < 3; ++i)
        shown[i] = static_cast<int>(
            srgb_from_linear(std::clamp(ramp.stops[stop].color[i], 0.0, 1.0)) * 255 + 0.5);
    const ImVec2 tip = low + ImVec2(handle_wide / 2, -4);
    const ImVec2 shape[] = {tip, low + ImVec2(handle_wide, 4),
                            low + ImVec2(handle_wide, handle_tall), low + ImVec2(0, handle_tall),
                            low + ImVec2(0, 4)};
    list.AddConvexPolyFilled(shape, 5, IM_COL32(shown[0], shown[1], shown[2], 255));
    const bool selected = stop == ramp.selected();
    list.AddPolyline(shape, 5, selected ? theme::accent : theme::control, ImDrawFlags_Closed,
                     selected ? 2.5F : 1.5F);
}

ImVec2 handle_at(const Edited& ramp, size_t stop, ImVec2 strip) {
    const auto x = static_cast<float>(ramp.stops[stop].position) * ramp_wide;
    return strip + ImVec2(x - handle_wide / 2, ramp_tall + 4);
}

void use_handle(const Edited& ramp, size_t stop, ImVec2 strip) {
    ImGui::SetCursorScreenPos(handle_at(ramp, stop, strip));
    area_button(ramp.state, "ramp:stop" + std::to_string(stop + 1), {handle_wide, handle_tall});
    if (ImGui::IsItemActivated()) ramp.select(stop);
    const float at = (ImGui::GetIO().MousePos.x - strip.x) / ramp_wide;
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left))
        move_selected(ramp, static_cast<double>(at));
}

void draw_handles(const Edited& ramp, ImVec2 strip) {
    // Of handles at one position the first one takes the press, and the last one is in sight.
    const size_t selected = ramp.selected();
    use_handle(ramp, selected, strip);
    for (size_t i = 0; i < ramp.stops.size(); ++i)
        if (i != selected) use_handle(ramp, i, strip);
    for (size_t i = 0; i < ramp.stops.size(); ++i)
        if (i != selected) draw_handle(ramp, i, handle_at(ramp, i, strip));
    draw_handle(ramp, selected, handle_at(ramp, selected, strip));
}

void draw_ramp_strip(const Edited& ramp) {
    const ImVec2 at = ImGui::GetCursorScreenPos() + ImVec2(handle_wide / 2, 0);
    ImGui::SetCursorScreenPos(at);
    const Area strip = area_button(ramp.state, "ramp:strip", {ramp_wide, ramp_tall});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_strip(list, strip.low, strip.high, ramp.strip);
    list.AddRect(strip.low, strip.high, theme::control);
    draw_handles(ramp, at);
    ImGui::SetCursorScreenPos(at + ImVec2(-handle_wide / 2, ramp_tall + handle_tall + 12));
    const float x = (ImGui::GetIO().MousePos.x - at.x) / ramp_wide;
    if (strip.pressed) add_stop(ramp, std::clamp(static_cast<double>(x), 0.0, 1.0));
}

void draw_position(const Edited& ramp) {
    ImGui::AlignTextToFramePadding();
    ImGui::Text("Stop %zu of %zu at", ramp.selected() + 1, ramp.stops.size());
    ImGui::SameLine();
    auto position = static_cast<float>(ramp.stops[ramp.selected()].position);
    ImGui::SetNextItemWidth(72);
    const bool moved = ImGui::DragFloat("##position", &position, 0.002F, 0, 1, "%.3f");
    name_item(ramp.state, "ramp:position");
    note_held(ramp.state);
    if (moved) move_selected(ramp, static_cast<double>(position));
    ImGui::SameLine();
    if (button(ramp.state, "Add", "ramp:add")) add_beside(ramp);
    ImGui::SameLine();
    if (button(ramp.state, "Remove", "ramp:remove")) remove_selected(ramp);
}

void draw_stop_color(const Edited& ramp) {
    const std::string port = color_port(ramp.selected());
    if (is_on_wire(ramp, port)) return ImGui::TextDisabled("%s is set by a wire.", port.c_str());
    std::array<float, 3> color{};
    std::ranges::transform(ramp.stops[ramp.selected()].color, color.begin(),
                           [](double each) { return static_cast<float>(each); });
    const bool changed = pick_color(ramp.state, "ramp:color", color);
    note_held(ramp.state);
    if (changed)
        ramp.commit(with_stop_color(ramp.state.document(), ramp.node, ramp.type, ramp.selected(),
                                    {color[0], color[1], color[2]}));
}

void use_keys(const Edited& ramp) {
    if (ImGui::GetIO().WantTextInput) return;
    const int step = is_pressed(ImGuiKey_RightArrow) - is_pressed(ImGuiKey_LeftArrow);
    const int last = static_cast<int>(ramp.stops.size()) - 1;
    const double position = ramp.stops[ramp.selected()].position;
    if (step != 0 && ImGui::GetIO().KeyShift)
        move_selected(ramp, position + step * key_step);
    else if (step != 0)
        ramp.state.popup.lane = std::clamp(ramp.state.popup.lane + step, 0, last);
    if (is_pressed(ImGuiKey_Insert)) add_beside(ramp);
    if (is_pressed(ImGuiKey_Delete)) remove_selected(ramp);
}

}  // namespace

bool draw_ramp(State& state) {
    const Card* card = state.layout.find(state.popup.node);
    const NodePtr* node = state.document().nodes.find(state.popup.node);
    if (!card || !node || !is_ramp(card->type)) return true;
    const NodePtr held = *node;  // edits replace the node of the document
    const Edited ramp{state, *held, *card->type, stops_of(*held, *card->type), card->strip};
    state.popup.lane = std::clamp(state.popup.lane, 0, static_cast<int>(ramp.stops.size()) - 1);
    if (!ImGui::IsAnyItemActive())
        state.popup.merge = "ramp " + std::to_string(state.history.serial());
    draw_ramp_strip(ramp);
    draw_position(ramp);
    draw_stop_color(ramp);
    if (state.popup.opening) return false;  // the key that opened it is still pressed
    use_keys(ramp);
    if (is_pressed(ImGuiKey_Tab, false)) state.popup.next = 1;
    return state.popup.next != 0 || is_pressed(ImGuiKey_Enter, false);
}

}  // namespace wrinkle::editor

// The color picker and its eyedropper.
#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "base/srgb.h"
#include "editor/model/oklch.h"
#include "editor/view/input/input_queue.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

using PickedColor = std::array<float, 3>;
constexpr float picker_wide = 220;

PickedColor display_of(const PickedColor& linear) {
    PickedColor display;
    std::ranges::transform(linear, display.begin(), [](float each) {
        return static_cast<float>(srgb_from_linear(static_cast<double>(each)));
    });
    return display;
}

PickedColor linear_of(const PickedColor& display) {
    PickedColor linear;
    std::ranges::transform(display, linear.begin(), [](float each) {
        return static_cast<float>(linear_from_srgb(static_cast<double>(each)));
    });
    return linear;
}

// A row of lightness, chroma and hue. A grey has the hue that was chosen last.
bool draw_oklch(State& state, const std::string& target, PickedColor& linear) {
    glm::dvec3 lch = oklch_of({linear[0], linear[1], linear[2]});
    float& hue = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("hue"));
    if (lch.y > 1e-4) hue = static_cast<float>(lch.z);
    float light = static_cast<float>(lch.x), chroma = static_cast<float>(lch.y);
    const float space = ImGui::GetStyle().ItemInnerSpacing.x;
    bool changed = false;
    const auto draw = [&](const char* name, float& value, float step, float most,
                          const char* format) {
        ImGui::SetNextItemWidth((picker_wide - 2 * space) / 3);
        changed |= ImGui::DragFloat(name, &value, step, 0, most, format);
        name_item(state, target + (name + 1));  // "color#C"
        note_held(state);
    };
    draw("##L", light, 0.002F, 4, "L:%.3f");
    ImGui::SameLine(0, space);
    draw("##C", chroma, 0.001F, 0.5F, "C:%.3f");
    ImGui::SameLine(0, space);
    draw("##h", hue, 0.5F, 360, "h:%.0f");
    if (!changed) return false;
    const glm::dvec3 made = glm::max(linear_of_oklch({light, chroma, hue}), 0.0);
    for (int i = 0; i < 3; ++i)
        linear[static_cast<size_t>(i)] = static_cast<float>(made[i]);
    return true;
}

// Returns the linear color under the pointer: in the 2D view the value of a color or a number,
// elsewhere that of the pixel.
std::optional<PickedColor> color_at_pointer(const State& state) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const FlatPanel& panel = state.flat.panel;
    const FlatValues& values = state.flat.shown.values;
    if (panel.contains(mouse) && (values.lanes == 1 || values.type == PortType::color_))
        if (const auto lanes =
                values_at(state.flat.shown, panel.u_at(mouse.x), panel.v_at(mouse.y))) {
            PickedColor color;
            for (size_t i = 0; i < 3; ++i)
                color[i] = static_cast<float>((*lanes)[std::min(i, lanes->size() - 1)]);
            return color;
        }
    if (!state.eyedropper.pixel) return std::nullopt;
    return linear_of(*state.eyedropper.pixel);
}

// At the lower right of the pointer; on its other side where the window ends.
void draw_swatch(const PickedColor& linear) {
    const ImVec2 mouse = ImGui::GetIO().MousePos, room = ImGui::GetIO().DisplaySize;
    const ImVec2 size(40, 40), offset(14, 14);
    const ImVec2 low(
        mouse.x + offset.x + size.x > room.x ? mouse.x - offset.x - size.x : mouse.x + offset.x,
        mouse.y + offset.y + size.y > room.y ? mouse.y - offset.y - size.y : mouse.y + offset.y);
    const PickedColor shown = display_of(linear);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, low + size,
                       ImGui::ColorConvertFloat4ToU32({shown[0], shown[1], shown[2], 1}), 4);
    list.AddRect(low, low + size, theme::text, 4);
}

// Takes the color under the pointer by a click or Enter. The popup covers the window, so that the
// click has no other effect. Returns true if a color was taken.
bool use_eyedropper(State& state, const std::string& target, PickedColor& linear) {
    constexpr const char* id = "##eyedropper";
    const bool typed = !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(key_named("I"), false);
    if (button(state, "Pick from the window  I", target + "#pick", false, {picker_wide, 0}) ||
        typed)
        ImGui::OpenPopup(id);
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_PopupBorderSize, 0.0F);
    ImGui::PushStyleColor(ImGuiCol_PopupBg, 0);
    state.eyedropper.drawn = ImGui::BeginPopup(id);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    if (!state.eyedropper.drawn) return false;
    const bool chosen = press_area("##window", room) || is_pressed(ImGuiKey_Enter, false);
    const std::optional<PickedColor> color = color_at_pointer(state);
    if (color) draw_swatch(*color);
    if (chosen || is_pressed(ImGuiKey_Escape, false)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    if (chosen && color) linear = *color;
    return chosen && color;
}

}  // namespace

bool pick_color(State& state, const std::string& target, std::array<float, 3>& linear) {
    PickedColor shown = display_of(linear);
    ImGui::SetNextItemWidth(picker_wide);
    const bool changed = ImGui::ColorPicker3(
        "##color", shown.data(),
        ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_NoAlpha |
            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_DisplayRGB |
            ImGuiColorEditFlags_DisplayHSV | ImGuiColorEditFlags_DisplayHex);
    name_item(state, target);
    note_held(state);
    if (changed) linear = linear_of(shown);
    const bool mixed = draw_oklch(state, target, linear);
    return use_eyedropper(state, target, linear) || mixed || changed;
}

}  // namespace wrinkle::editor

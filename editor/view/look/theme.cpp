#include "editor/view/look/theme.h"
#include <algorithm>
#include <cmath>

namespace wrinkle::editor::theme {
namespace {

Theme current = Theme::dark;

struct TypeColor {
    PortType type;
    ImU32 dark, light;
};
constexpr TypeColor type_colors[] = {
    {PortType::float_, rgb(0xF2F5F3), rgb(0x3B382E)},
    {PortType::vec2_, rgb(0x388F7E), rgb(0x34949A)},
    {PortType::vec3_, rgb(0x1FA4FF), rgb(0x237CFA)},
    {PortType::vec4_, rgb(0x7A80A7), rgb(0x1E0DB1)},
    {PortType::color_, rgb(0xF69EB3), rgb(0x6C0C4E)},
    {PortType::height_, rgb(0xFFD424), rgb(0x9F7002)},
    {PortType::derivative_, rgb(0xC27700), rgb(0x802E02)},
    {PortType::gradient_, rgb(0xADFFB3), rgb(0x416D4C)},
    {PortType::normal_, rgb(0xD9CAFF), rgb(0x645C89)},
    {PortType::image_, rgb(0xE33E76), rgb(0xF5346E)},
    {PortType::material_, rgb(0xAAB46E), rgb(0x140014)},
};

void style_colors() {
    const auto set = [](ImGuiCol which, ImU32 color) {
        ImGui::GetStyle().Colors[which] = ImGui::ColorConvertU32ToFloat4(color);
    };
    current == Theme::dark ? ImGui::StyleColorsDark() : ImGui::StyleColorsLight();
    set(ImGuiCol_Text, text);
    set(ImGuiCol_TextDisabled, text_off);
    set(ImGuiCol_WindowBg, panel);
    set(ImGuiCol_ChildBg, with_alpha(panel, 0));
    set(ImGuiCol_PopupBg, node);
    set(ImGuiCol_Border, border);
    set(ImGuiCol_FrameBg, field);
    set(ImGuiCol_FrameBgHovered, accent_soft);
    set(ImGuiCol_FrameBgActive, accent_soft);
    set(ImGuiCol_MenuBarBg, bar);
    set(ImGuiCol_Button, panel);
    set(ImGuiCol_ButtonHovered, accent_soft);
    set(ImGuiCol_ButtonActive, accent_fill);
    set(ImGuiCol_Header, accent_soft);
    set(ImGuiCol_HeaderHovered, accent_soft);
    set(ImGuiCol_HeaderActive, accent_soft);
    set(ImGuiCol_CheckMark, accent);
    set(ImGuiCol_SliderGrab, accent);
    set(ImGuiCol_Separator, border);
    set(ImGuiCol_ScrollbarBg, with_alpha(panel, 0));
    set(ImGuiCol_ScrollbarGrab, control);
    set(ImGuiCol_NavHighlight, accent);
    set(ImGuiCol_TextSelectedBg, accent_soft);
    set(ImGuiCol_PlotHistogram, accent);
    set(ImGuiCol_ModalWindowDimBg, IM_COL32(0, 0, 0, current == Theme::dark ? 128 : 77));
}

void style_shapes() {
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowPadding = {8, 8};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 4};
    style.WindowRounding = 0;
    style.PopupRounding = 8;
    style.FrameRounding = 5;
    style.ScrollbarSize = 10;
    style.WindowBorderSize = 0;
    style.FrameBorderSize = 1;
    style.DisabledAlpha = 0.5F;
}

}  // namespace

ImU32 of(PortType type) {
    const auto& color = *std::ranges::find(type_colors, type, &TypeColor::type);
    return current == Theme::dark ? color.dark : color.light;
}

void use(Theme theme) {
    current = theme;
#define X(name, of_dark, of_light) name = rgb(theme == Theme::dark ? of_dark : of_light);
    WRINKLE_THEME_COLORS(X)
#undef X
    shadow = theme == Theme::dark ? IM_COL32(0, 0, 0, 71) : IM_COL32(0, 0, 0, 0);
    if (!ImGui::GetCurrentContext()) return;
    style_shapes();
    style_colors();
}

Theme used() {
    return current;
}

}  // namespace wrinkle::editor::theme

namespace wrinkle::editor {

HeatColor heat_color(float part) {
    const float at = std::clamp(part, 0.0F, 1.0F) * (heat_stops.size() - 1);
    const size_t low = std::min(static_cast<size_t>(at), heat_stops.size() - 2);
    const float t = at - static_cast<float>(low);
    const auto channel = [&](unsigned shift) {
        const auto a = static_cast<float>(heat_stops[low] >> shift & 255);
        const auto b = static_cast<float>(heat_stops[low + 1] >> shift & 255);
        return static_cast<int>(std::lround(a + (b - a) * t));
    };
    // Black and white have equal contrast at luminance 0.18, a quarter step after the fifth stop.
    const ImU32 text = at <= 4.25F ? IM_COL32(255, 255, 255, 255) : IM_COL32(0, 0, 0, 255);
    return {IM_COL32(channel(16), channel(8), channel(0), 255), text};
}

}  // namespace wrinkle::editor

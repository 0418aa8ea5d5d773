#include "editor/look/theme.h"

namespace wrinkle::editor::theme {

ImU32 of(PortType type) {
    switch (type) {
        case PortType::float_:
            return rgb(0xF2F5F3);
        case PortType::vec2_:
            return rgb(0x4A8E86);
        case PortType::vec3_:
            return rgb(0x1BA3FE);
        case PortType::vec4_:
            return rgb(0x767AAC);
        case PortType::color_:
            return rgb(0xF8A7AD);
        case PortType::height_:
            return rgb(0xF6CC18);
        case PortType::derivative_:
            return rgb(0xD58105);
        case PortType::gradient_:
            return rgb(0xCDFEAE);
        case PortType::normal_:
            return rgb(0xDDC9FF);
        case PortType::image_:
            return rgb(0xDF435D);
    }
    return text;
}

void apply_style() {
    ImGui::StyleColorsDark();
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
    const auto set = [&](ImGuiCol which, ImU32 color) {
        style.Colors[which] = ImGui::ColorConvertU32ToFloat4(color);
    };
    set(ImGuiCol_Text, text);
    set(ImGuiCol_TextDisabled, text_off);
    set(ImGuiCol_WindowBg, panel);
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
    set(ImGuiCol_HeaderActive, accent_fill);
    set(ImGuiCol_Separator, border);
    set(ImGuiCol_ScrollbarBg, panel);
    set(ImGuiCol_NavHighlight, accent);
    set(ImGuiCol_TextSelectedBg, accent_fill);
}

}  // namespace wrinkle::editor::theme

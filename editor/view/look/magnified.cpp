#include "editor/view/look/magnified.h"

#include <imgui_internal.h>

#include <cmath>

#include "editor/view/look/draw.h"

namespace wrinkle::editor {
namespace {

ImFont* measuring_font(const Fonts& fonts, const TextStyle& style) {
    return style.bold ? fonts.bold(style.size) : fonts.regular(style.size);
}

void draw_bar(ImDrawList& list, const TextStyle& style, float zoom, ImVec2 at, ImU32 color,
              float width) {
    const float tall = std::max(style.size * zoom * 0.35F, 1.0F);
    const ImVec2 low(at.x, at.y + (style.size * zoom - tall) / 2);
    const ImU32 pale = (color & ~IM_COL32_A_MASK) | 110U << IM_COL32_A_SHIFT;
    list.AddRectFilled(low, low + ImVec2(width, tall), pale);
}

void add_glyph(ImDrawList& list, const ImFontGlyph& glyph, ImVec2 origin, float scale,
               ImU32 color) {
    const ImVec2 low = origin + ImVec2(glyph.X0, glyph.Y0) * scale;
    const ImVec2 high = origin + ImVec2(glyph.X1, glyph.Y1) * scale;
    if (high.x < list.GetClipRectMin().x || low.x > list.GetClipRectMax().x) return;
    list.PrimReserve(6, 4);
    list.PrimRectUV(low, high, {glyph.U0, glyph.V0}, {glyph.U1, glyph.V1}, color);
}

}  // namespace

void draw_magnified(ImDrawList& list, const Fonts& fonts, const TextStyle& style, float zoom,
                    ImVec2 at, ImU32 color, std::string_view text) {
    const float tall = style.size * zoom;
    if (at.y > list.GetClipRectMax().y || at.y + tall < list.GetClipRectMin().y) return;
    ImFont* measure = measuring_font(fonts, style);
    if (style.right_aligned || tall < min_text) {
        const float width = magnified_width(fonts, style, text) * zoom;
        if (style.right_aligned) at.x -= width;
        if (tall < min_text) return draw_bar(list, style, zoom, at, color, width);
    }
    float drawn = tall;
    ImFont* font = fonts.magnified(style.bold, tall, drawn);
    const float pixel = 1 / fonts.scale();
    at.y = std::round((at.y + (tall - drawn) / 2) / pixel) * pixel;
    const float step = measure->Scale * zoom;
    for (const char *c = text.data(), *end = c + text.size(); c < end;) {
        unsigned code = 0;
        c += ImTextCharFromUtf8(&code, c, end);
        const ImFontGlyph* glyph = font->FindGlyph(static_cast<ImWchar>(code));
        const ImVec2 origin(std::round(at.x / pixel) * pixel, at.y);
        if (glyph && glyph->Visible) add_glyph(list, *glyph, origin, drawn / font->FontSize, color);
        at.x += measure->GetCharAdvance(static_cast<ImWchar>(code)) * step;
    }
}

float magnified_width(const Fonts& fonts, const TextStyle& style, std::string_view text) {
    return text_width(measuring_font(fonts, style), style.size, text);
}

std::string magnified_fitting(const Fonts& fonts, const TextStyle& style, std::string_view text,
                              float width) {
    return fitting(measuring_font(fonts, style), style.size, text, width);
}

}  // namespace wrinkle::editor

// Preview image: pointer input, the two sides, the scale of angles, notice of a stale image.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "editor/view/input/input_queue.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/preview_parts.h"
#include "editor/view/preview/feed.h"

namespace wrinkle::editor {
namespace {

constexpr float pi = 3.14159265F;

void turn_light(PreviewView& view, ImVec2 delta) {
    view.turn += delta.x * 0.01F;
    view.light_pitch = std::clamp(view.light_pitch - delta.y * 0.01F, -pi / 2, pi / 2);
}

// Left drag: orbit; with Shift: pan; with L: turn the light. Middle drag: pan. Right drag: turn the
// light. Wheel: camera distance.
void handle(CanvasState& canvas, const Rect& area) {
    PreviewView& view = canvas.view.preview_view;
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive()) {
        const ImVec2 d = io.MouseDelta;
        const bool left = io.MouseDown[0], right = io.MouseDown[1];
        if (io.MouseDown[2] || (left && io.KeyShift)) {
            const float scale = 0.5F * view.distance / std::min(area.size.x, area.size.y);
            view.pan_x -= d.x * scale;
            view.pan_y += d.y * scale;
        } else if (right || (left && io.KeysDown[key_named("L")])) {
            turn_light(view, d);
        } else if (left) {
            view.yaw -= d.x * 0.01F;
            view.pitch = std::clamp(view.pitch + d.y * 0.01F, -1.5F, 1.5F);
        }
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0)
        view.distance = std::clamp(view.distance * std::pow(1.1F, -io.MouseWheel), 0.05F, 20.0F);
}

bool splits(const CanvasState& canvas, const PreviewImage& image) {
    return canvas.view.compare.mode == CompareView::Mode::split && image.other != 0;
}

// Returns true while the line between the sides is hovered or dragged.
bool drag_split(State& state, const Rect& area) {
    float& split = state.view.compare.split;
    const float x = area.at.x + area.size.x * split;
    ImGui::SetCursorScreenPos({x - 7, area.at.y});
    const bool hovered = area_button(state, "compare:line", {14, area.size.y}).hovered;
    if (!ImGui::IsItemActive()) return hovered;
    split = std::clamp(split + ImGui::GetIO().MouseDelta.x / area.size.x, 0.02F, 0.98F);
    return true;
}

// Background gradient: #282A2D in the middle, #1A1C1E in the corners.
void draw_ground(ImDrawList& list, const Rect& area) {
    const ImU32 middle = theme::rgb(0x282A2D), corner = theme::rgb(0x1A1C1E);
    const ImVec2 center = area.at + area.size * 0.5F;
    const ImVec2 a = area.at, b = area.end();
    const ImU32 edge = theme::rgb(0x212326);
    list.AddRectFilledMultiColor(a, center, corner, edge, middle, edge);
    list.AddRectFilledMultiColor({center.x, a.y}, {b.x, center.y}, edge, corner, edge, middle);
    list.AddRectFilledMultiColor({a.x, center.y}, {center.x, b.y}, edge, middle, edge, corner);
    list.AddRectFilledMultiColor(center, b, middle, edge, corner, edge);
}

void draw_image(ImDrawList& list, const Rect& area, uint32_t texture, float from, float to) {
    if (!texture || from >= to) return;
    list.AddImage(texture_id(texture), {area.at.x + area.size.x * from, area.at.y},
                  {area.at.x + area.size.x * to, area.end().y}, {from, 1}, {to, 0});
}

void draw_line(ImDrawList& list, const Rect& area, float split) {
    const float x = std::round(area.at.x + area.size.x * split);
    const float y = area.at.y + area.size.y / 2;
    list.AddRectFilled({x - 1, area.at.y}, {x + 1, area.end().y}, theme::text);
    list.AddRectFilled({x - 7, y - 16}, {x + 7, y + 16}, theme::text, 4);
    for (const float dx : {-2.5F, 1.0F})
        list.AddRectFilled({x + dx, y - 6}, {x + dx + 1.5F, y + 6}, theme::canvas);
}

void draw_sides(State& state, const Rect& area, const PreviewImage& image) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const CompareView& compare = state.view.compare;
    const bool other = compare.mode == CompareView::Mode::flip && compare.flipped && image.other;
    const float split = splits(state, image) ? compare.split : 1;
    draw_image(list, area, other ? image.other : image.texture, 0, split);
    draw_image(list, area, image.other, split, 1);
    if (splits(state, image)) draw_line(list, area, split);
    if (!image.other) return;
    const std::string b = (compare.difference ? "B  Difference to " : "B  ") +
                          against_label(state.view.preview_request);
    if (splits(state, image) || !other)
        draw_chip(state.fonts, area.at + ImVec2(12, 12), "A  Surface gradient");
    if (splits(state, image) || other)
        draw_chip(state.fonts, {area.end().x - 12, area.at.y + 12}, b, true);
}

std::string degrees(float value, const char* before = "") {
    char text[48];
    std::snprintf(text, sizeof text, "%s%.1f°", before, static_cast<double>(value));
    return text;
}

void draw_scale(ImDrawList& list, ImVec2 at, float width) {
    constexpr size_t steps = heat_stops.size() - 1;
    const float step = width / steps;
    for (size_t i = 0; i < steps; ++i) {
        const ImU32 a = theme::rgb(heat_stops[i]), b = theme::rgb(heat_stops[i + 1]);
        const ImVec2 low = at + ImVec2(step * static_cast<float>(i), 0);
        list.AddRectFilledMultiColor(low, low + ImVec2(step + 0.5F, 10), a, b, b, a);
    }
}

void draw_legend(const Fonts& fonts, const Rect& area, const AngleFigures& angles) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 size(196, 66), at = area.end() - size - ImVec2(12, 12);
    list.AddRectFilled(at, at + size, theme::with_alpha(theme::canvas, 0.88F), 4);
    ImFont* bold = fonts.bold(14);
    draw_text(list, bold, 14, at + ImVec2(10, 6), theme::text, degrees(angles.mean, "Mean "));
    draw_text(list, bold, 14, at + ImVec2(size.x - 10, 6), theme::text, degrees(angles.max, "Max "),
              true);
    const float width = size.x - 20;
    draw_scale(list, at + ImVec2(10, 32), width);
    const float x = at.x + 10 + width * std::clamp(angles.mean / angles.end, 0.0F, 1.0F);
    list.AddTriangleFilled({x - 5, at.y + 25}, {x + 5, at.y + 25}, {x, at.y + 31}, theme::text);
    ImFont* small = fonts.regular(14);
    for (int i = 0; i < 4; ++i) {
        char text[24];
        std::snprintf(text, sizeof text, i == 3 && angles.max > angles.end ? "≥ %.0f°" : "%.0f°",
                      static_cast<double>(angles.end * static_cast<float>(i) / 3));
        const float w = text_width(small, 14, text);
        const float left = 10 + width * static_cast<float>(i) / 3 -
                           (i == 0   ? 0
                            : i == 3 ? w
                                     : w / 2);
        draw_text(list, small, 14, at + ImVec2(left, 46), theme::text_dim, text);
    }
}

// Draws the angle at the pointer if side B shows angles.
void draw_angle_here(State& state, const Rect& area, const PreviewImage& image) {
    const ImVec2 mouse = ImGui::GetIO().MousePos - area.at;
    const auto& list = image.angles.degrees;
    if (!list || image.width < 1 || mouse.x < 0 || mouse.y < 0 || mouse.x >= area.size.x ||
        mouse.y >= area.size.y)
        return;
    const bool side_b = splits(state, image) ? mouse.x > area.size.x * state.view.compare.split
                                             : state.view.compare.flipped;
    if (!side_b) return;
    const auto x = static_cast<int>(mouse.x / area.size.x * static_cast<float>(image.width));
    const auto y = static_cast<int>((1 - mouse.y / area.size.y) * static_cast<float>(image.height));
    const int row = std::clamp(y, 0, image.height - 1);
    const float value = (*list)[static_cast<size_t>(row * image.width + x)];
    if (value >= 0)
        draw_chip(state.fonts, ImGui::GetIO().MousePos + ImVec2(14, 10), degrees(value));
}

std::string first_reason(const State& state) {
    for (const Diagnostics* list :
         {&state.built.live, &state.built.problems, &state.preview_problems})
        if (const std::string error = first_error(*list); !error.empty()) return sentence(error);
    return state.document().outputs.empty() ? "The graph has no outputs." : "";
}

// Returns the reason why the image is not that of the document; "" if it is.
std::string why_stale(const State& state, const PreviewImage& image) {
    if (!state.preview_stale)
        return state.preview_problems.has_errors() ? first_reason(state)
                                                   : state.built.why_not_shown;
    return (image.texture ? "Showing the last good image. " : "No image yet. ") +
           first_reason(state);
}

void draw_notes(const State& state, const Rect& area, const PreviewImage& image) {
    const PreviewView& view = state.view.preview_view;
    const std::string mesh = capitalised(std::filesystem::path(view.mesh).stem().string());
    char text[96];
    std::snprintf(text, sizeof text, "%.40s %.2f m", mesh.c_str(), static_cast<double>(view.scale));
    const std::string time = image.first ? "" : ", frame " + milliseconds(image.milliseconds);
    if (image.texture) draw_chip(state.fonts, {area.at.x + 12, area.end().y - 38}, text + time);
    if (!image.texture && holds_nothing(state.document())) return;
    const std::string why = why_stale(state, image);
    if (!why.empty())
        draw_strip(state.fonts, area.at, area.size.x, theme::with_alpha(theme::canvas, 0.88F),
                   theme::warn, why);
}

}  // namespace

float draw_chip(const Fonts& fonts, ImVec2 at, const std::string& text, bool right_aligned,
                ImU32 color) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImFont* font = fonts.regular(14);
    const float width = text_width(font, 14, text) + 16;
    if (right_aligned) at.x -= width;
    list.AddRectFilled(at, at + ImVec2(width, 26), theme::with_alpha(theme::canvas, 0.88F), 4);
    draw_text(list, font, 14, at + ImVec2(8, 6), color ? color : theme::text, text);
    return width;
}

void draw_preview_image(State& state, ImVec2 at, ImVec2 size) {
    const Rect area{at, size};
    static const PreviewImage none;
    const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
    if (state.preview)
        state.preview->show(state.view.preview_view, other_normal(state), state.view.compare,
                            static_cast<int>(size.x * pixels.x),
                            static_cast<int>(size.y * pixels.y));
    const PreviewImage& image = state.preview ? state.preview->shown() : none;
    const bool on_line = splits(state, image) && drag_split(state, area);
    ImGui::SetCursorScreenPos(at);
    if (!on_line) {
        press_area("picture", size,
                   ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                       ImGuiButtonFlags_MouseButtonMiddle);
        handle(state, area);
    }
    name_area(state, "preview", at, area.end());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(at, area.end(), true);
    draw_ground(list, area);
    draw_sides(state, area, image);
    draw_notes(state, area, image);
    if (image.angles.degrees) {
        draw_legend(state.fonts, area, image.angles);
        draw_angle_here(state, area, image);
    }
    list.PopClipRect();
}

}  // namespace wrinkle::editor

// The 2D view in the preview panel: a node's values over uv, read under the pointer.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/text.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/preview_parts.h"
#include "editor/view/preview/flat.h"

namespace wrinkle::editor {
namespace {

constexpr double least_span = 1e-6, most_span = 64;
constexpr float flat_bar = 28;

// Left or middle drag: moves the view. Wheel: zooms at the pointer.
void handle_flat(State& state, const FlatPanel& panel) {
    FlatView& view = state.view.flat;
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive() && !ImGui::IsItemActivated()) {
        view.u -= static_cast<double>(io.MouseDelta.x) * panel.pixel();
        view.v += static_cast<double>(io.MouseDelta.y) * panel.pixel();
    }
    if (!ImGui::IsItemHovered() || io.MouseWheel == 0) return;
    const double u = panel.u_at(io.MousePos.x), v = panel.v_at(io.MousePos.y);
    const double span = std::clamp(view.span * std::pow(1.1, -static_cast<double>(io.MouseWheel)),
                                   least_span, most_span);
    const double scale = span / view.span;
    view.u = u + (view.u - u) * scale;
    view.v = v + (view.v - v) * scale;
    view.span = span;
}

void draw_values(const FlatFeed& feed, const FlatPanel& panel, ImDrawList& list) {
    const FlatArea& area = feed.shown.area;
    if (!feed.texture || feed.shown.texels.empty()) return;
    list.AddImage(texture_id(feed.texture),
                  {panel.x_of(area.u), panel.y_of(area.v + area.texel * area.height)},
                  {panel.x_of(area.u + area.texel * area.width), panel.y_of(area.v)}, {0, 1},
                  {1, 0});
}

// Lines at integers, where a tile ends; none if they are close together.
void draw_tiles(const FlatPanel& panel, ImDrawList& list) {
    constexpr double closest = 12;  // pixels
    if (panel.pixel() * closest > 1) return;
    const ImU32 color = theme::with_alpha(theme::accent, 0.7F);
    const ImVec2 low = panel.at, high = panel.end;
    for (double u = std::ceil(panel.u_at(low.x)); u <= panel.u_at(high.x); ++u)
        list.AddLine({panel.x_of(u), low.y}, {panel.x_of(u), high.y}, color);
    for (double v = std::ceil(panel.v_at(high.y)); v <= panel.v_at(low.y); ++v)
        list.AddLine({low.x, panel.y_of(v)}, {high.x, panel.y_of(v)}, color);
}

std::string number_text(double value, int digits = 5) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

void draw_value_here(State& state, const FlatPanel& panel) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const double u = panel.u_at(mouse.x), v = panel.v_at(mouse.y);
    const auto lanes = values_at(state.flat.shown, u, v);
    if (!lanes) return;
    std::string text = "u " + number_text(u) + "  v " + number_text(v) + "   ";
    for (size_t i = 0; i < lanes->size(); ++i)
        text += (i ? ", " : "") + number_text((*lanes)[i]);
    state.flat.at_pointer = text;
    const float wide = text_width(state.fonts.regular(14), 14, text) + 16;
    const float x = std::min(mouse.x + 14, panel.end.x - wide);
    draw_chip(state.fonts, {x, std::min(mouse.y + 10, panel.end.y - 26)}, text);
}

void draw_histogram(const State& state, const FlatPanel& panel, ImDrawList& list) {
    const FlatImage& image = state.flat.shown;
    const uint32_t highest = *std::ranges::max_element(image.histogram);
    if (highest == 0 || panel.end.x - panel.at.x < 320 || panel.end.y - panel.at.y < 200) return;
    const std::string least = number_text(image.range.least, 3);
    const std::string mean = "mean " + number_text(image.mean, 3);
    const std::string most = number_text(image.range.most, 3);
    ImFont* font = state.fonts.regular(14);
    const auto wide = [&](const std::string& text) { return text_width(font, 14, text); };
    constexpr float pad = 8, gap = 12;
    const float words = wide(least) + gap + wide(mean) + gap + wide(most);
    const ImVec2 size(std::max(words, 192.0F) + 2 * pad, 84),
        at = panel.end - size - ImVec2(12, 12);
    list.AddRectFilled(at, at + size, theme::with_alpha(theme::canvas, 0.88F), 4);
    const float left = at.x + pad, right = at.x + size.x - pad, floor = at.y + 54;
    const float step = (right - left) / static_cast<float>(FlatImage::bins);
    for (size_t i = 0; i < FlatImage::bins; ++i) {
        const float tall =
            46 * std::sqrt(static_cast<float>(image.histogram[i]) / static_cast<float>(highest));
        const float x = left + step * static_cast<float>(i);
        list.AddRectFilled({x, floor - tall}, {x + step - 0.5F, floor}, theme::text_dim);
    }
    const float middle = (left + wide(least) + right - wide(most)) / 2;
    draw_text(list, font, 14, {left, at.y + 62}, theme::text, least);
    draw_text(list, font, 14, {middle - wide(mean) / 2, at.y + 62}, theme::text_dim, mean);
    draw_text(list, font, 14, {right, at.y + 62}, theme::text, most, true);
}

std::vector<Item> channel_items(const FlatValues& values) {
    constexpr const char* colors[] = {"R", "G", "B", "A"};
    constexpr const char* axes[] = {"X", "Y", "Z", "W"};
    std::vector<Item> items{{"All", "flat:all"}};
    for (size_t i = 0; i < std::min(values.lanes, size_t{4}); ++i) {
        const char* name = values.type == PortType::color_ ? colors[i] : axes[i];
        items.push_back({name, "flat:" + std::to_string(i)});
    }
    return items;
}

// The channels of a material, under its name.
void choose_output(State& state, const FlatPanel& panel) {
    const FlatValues& values = state.flat.shown.values;
    if (values.channels.empty()) return;
    std::vector<Item> items;
    for (const std::string& name : values.channels)
        items.push_back({name, "flat:output:" + name});
    ImGui::SetCursorScreenPos(panel.at + ImVec2(12, 44));
    const int picked = choose(state, "flat:output", values.channel, items, 180);
    if (picked >= 0) state.view.flat.output = items[static_cast<size_t>(picked)].label;
}

// Channels at the upper right corner, and the range of gray.
void draw_flat_bar(State& state, const FlatPanel& panel) {
    FlatView& view = state.view.flat;
    const FlatValues& values = state.flat.shown.values;
    if (values.node.empty()) return;
    const bool gray = values.lanes == 1 || view.channel >= 0;
    float right = panel.end.x - 12;
    if (values.lanes > 1) {
        const std::vector<Item> items = channel_items(values);
        const float width = 36 * static_cast<float>(items.size());
        right -= width;
        ImGui::SetCursorScreenPos({right, panel.at.y + 12});
        const int picked = segments(state, items, view.channel + 1, width);
        if (picked >= 0) view.channel = picked - 1;
        right -= 8;
    }
    if (!gray) return;
    const Item ranges[] = {{"Range", "flat:range", "Black to white over the visible values"},
                           {"0 to 1", "flat:unit", "Black is 0, white is 1"}};
    ImGui::SetCursorScreenPos({right - 128, panel.at.y + 12});
    const int picked = segments(state, ranges, view.fits_range ? 0 : 1, 128);
    if (picked >= 0) view.fits_range = picked == 0;
}

void draw_flat_name(const State& state, const FlatPanel& panel) {
    const std::string node = flat_node(state);
    const FlatValues& values = state.flat.shown.values;
    std::string text = node.empty() ? "Select a node to see its values." : node;
    if (!node.empty() && state.flat.shown.version && values.node.empty())
        text += " makes nothing that can be shown, or does not compile.";
    else if (!values.node.empty())
        text += "  " + std::string(name_of(values.type));
    const float bar = values.node.empty() ? 40 : 340;
    const float wide = std::max(panel.end.x - panel.at.x - bar, 96.0F);
    draw_chip(state.fonts, panel.at + ImVec2(12, 12),
              fitting(state.fonts.regular(14), 14, text, wide));
}

}  // namespace

void draw_flat(State& state, ImVec2 at, ImVec2 size) {
    const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
    const FlatPanel panel{at, at + size,
                          area_of(state.view.flat, size.x * pixels.x, size.y * pixels.y)};
    state.flat.panel = panel;
    feed_flat(state, panel.shown);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(at, panel.end, true);
    list.AddRectFilled(at, panel.end, theme::canvas);
    draw_values(state.flat, panel, list);
    draw_tiles(panel, list);
    draw_histogram(state, panel, list);
    draw_flat_name(state, panel);
    draw_flat_bar(state, panel);
    choose_output(state, panel);
    const float bar = 12 + (state.flat.shown.values.channels.empty() ? flat_bar : 2 * flat_bar + 8);
    FlatPanel below_bar = panel;
    below_bar.at.y += bar;
    use_flat_handles(state, below_bar);
    ImGui::SetCursorScreenPos(below_bar.at);
    press_area("flat", size - ImVec2(0, bar),
               ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
    name_area(state, "flat", at, panel.end);
    handle_flat(state, panel);
    state.flat.at_pointer.clear();
    if (ImGui::IsItemHovered()) draw_value_here(state, panel);
    list.PopClipRect();
}

}  // namespace wrinkle::editor

#include <algorithm>
#include <cctype>
#include <cmath>

#include "editor/view/canvas/painter.h"
#include "editor/view/look/tooltip.h"

namespace wrinkle::editor {
namespace {

// Number of line segments for a curve, by its length on the screen.
int pieces(const Curve& k, bool plain) {
    const float wide = std::fabs(k.d.x - k.a.x), tall = std::fabs(k.d.y - k.a.y);
    if (tall < 0.5F && k.d.x > k.a.x) return 1;
    const float back = k.d.x < k.a.x ? k.b.x - k.a.x : 0;
    const float length = wide + tall + 2 * back;
    // A wire that runs backwards turns sharply and needs more segments to avoid spikes.
    return plain ? std::clamp(static_cast<int>(length / 20), back > 0 ? 12 : 1, 12)
                 : std::clamp(4 + static_cast<int>(length / 14), 6, 32);
}

// Draws the part of the curve from parameter `from` to `to`.
void stroke(ImDrawList& list, const Curve& k, ImU32 color, float thickness, int count,
            float from = 0, float to = 1) {
    for (int i = 0; i <= count; ++i)
        list.PathLineTo(
            k.at(from + (to - from) * static_cast<float>(i) / static_cast<float>(count)));
    list.PathStroke(color, 0, thickness);
}

// Draws the pill on a wire that shows the conversion of its value.
void draw_conversion(const Painter& p, const Wire& wire, ImVec2 at) {
    const float z = p.zoom;
    const ImVec2 half(25 * z, 11 * z);
    const bool illegal = wire.conversion == Conversion::illegal;
    p.list.AddRectFilled(at - half, at + half, theme::node, half.y);
    p.list.AddRect(at - half, at + half, illegal ? theme::error : theme::line, half.y);
    const ImVec2 side(14 * z, 0);
    draw_pin(p.list, wire.from_type, at - side, 5 * z, theme::of(wire.from_type), true,
             theme::node);
    draw_pin(p.list, wire.to_type, at + side, 5 * z, theme::of(wire.to_type), true, theme::node);
    if (illegal) {
        p.list.AddLine(at - ImVec2(4, 4) * z, at + ImVec2(4, 4) * z, theme::error, 2 * z);
        p.list.AddLine(at - ImVec2(4, -4) * z, at + ImVec2(4, -4) * z, theme::error, 2 * z);
        return;
    }
    p.list.AddLine(at - ImVec2(5 * z, 0), at + ImVec2(3 * z, 0), theme::text, 1.5F * z);
    const ImVec2 tip[] = {at + ImVec2(1, -3) * z, at + ImVec2(4.5F, 0) * z, at + ImVec2(1, 3) * z};
    p.list.AddPolyline(tip, 3, theme::text, 0, 1.5F * z);
}

void explain(const Painter& p, const Wire& wire, const About& pill) {
    const std::string given(name_of(wire.from_type)), wanted(name_of(wire.to_type));
    std::string title = given + " to " + wanted;
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    if (wire.conversion != Conversion::illegal)
        return show_tooltip(pill, p.state.fonts.bold(16), title, doc(wire.conversion));
    show_tooltip(pill, p.state.fonts.bold(16), "A " + given + " is not a " + wanted + ".",
                 alternative(wire.from_type, wire.to_type, *p.state.registry));
}

// A converted wire changes its color in the middle.
void draw_line(const Painter& p, const Wire& wire, const Curve& k, ImU32 color, float thickness) {
    const int count = pieces(k, p.plain);
    const bool converts = wire.conversion != Conversion::same && wire.known && !p.plain;
    if (p.details) stroke(p.list, k, theme::canvas, thickness + 3, count);
    if (!converts || color == theme::accent) return stroke(p.list, k, color, thickness, count);
    const int half = std::max(count / 2, 3);
    stroke(p.list, k, color, thickness, half, 0, 0.5F);
    stroke(p.list, k, theme::of(wire.to_type), thickness, half, 0.5F, 1);
}

void draw_wire(const Painter& p, size_t index) {
    const Wire& wire = p.state.layout.wires[index];
    const Curve k = wire_curve(p.at(wire.start), p.at(wire.end), p.zoom);
    const bool hovered = p.state.hovered.kind == Hit::Kind::wire && p.state.hovered.part == index;
    const bool belongs = p.is_selected(wire.from_card) || p.is_selected(wire.to_card);
    float thickness = (hovered ? 4 : belongs ? 3 : 2.5F) * std::clamp(p.zoom, 0.5F, 1.5F);
    if (p.plain) thickness = hovered || belongs ? 2 : 1;
    ImU32 color = wire.known ? theme::of(wire.from_type) : theme::text_off;
    if (p.view.selected_wire && wire.ends_at(*p.view.selected_wire)) color = theme::accent;
    if (wire.conversion == Conversion::illegal)
        draw_dashed(p.list, k, theme::error, thickness, 6, 4);
    else
        draw_line(p, wire, k, color, thickness);
    const bool pill = wire.conversion != Conversion::same && wire.conversion != Conversion::rename;
    if (!pill || p.zoom < 0.5F) return;
    const ImVec2 middle = k.at(0.5F), half = ImVec2(25, 12) * p.zoom;
    draw_conversion(p, wire, middle);
    const ImVec2 off = ImGui::GetIO().MousePos - middle;
    if (hovered && std::fabs(off.x) < half.x && std::fabs(off.y) < half.y)
        explain(p, wire, {middle - half, middle + half});
}

}  // namespace

void draw_wires(const Painter& p) {
    const auto& boxes = p.state.layout.wire_boxes;
    for (size_t i = 0; i < boxes.size(); ++i) {
        if (!p.sees(boxes[i])) continue;
        const int first = p.list.VtxBuffer.Size;
        draw_wire(p, i);
        if (p.fades_wire(i)) fade(p.list, first);
    }
}

}  // namespace wrinkle::editor

// Draws the canvas from back to front: grid, frames, wires, cards, dragged wire, selection box.
#include <cmath>

#include "base/mapped.h"
#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/card_names.h"
#include "editor/view/canvas/gestures/gestures.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/painter.h"
#include "editor/view/look/theme.h"

namespace wrinkle::editor {
namespace {

void draw_grid(const Painter& p) {
    if (p.zoom < 0.5F) return;
    const float step = 32 * p.zoom;
    const ImVec2 end = p.view.corner + p.view.extent;
    const auto first = [&](float pan) { return std::fmod(std::fmod(pan, step) + step, step); };
    for (float y = p.view.corner.y + first(p.view.pan.y); y < end.y; y += step)
        for (float x = p.view.corner.x + first(p.view.pan.x); x < end.x; x += step)
            p.list.AddRectFilled({x - 1, y - 1}, {x + 1, y + 1}, theme::grid);
}

ImU32 name_color(const Painter& p, const CardName& name) {
    const Card& card = p.state.layout.cards[name.card];
    const Price* price = p.view.heat && !name.beside ? p.price(card) : nullptr;
    const ImU32 color = price        ? heat_color(p.heat(*price)).text
                        : card.muted ? theme::text_off
                                     : theme::text;
    return p.fades(name.card) ? theme::with_alpha(color, 0.35F) : color;
}

// Names of cards that are too small for their headers.
void draw_names(const Painter& p) {
    ImFont* font = p.state.fonts.regular(card_name_size);
    for (const CardName& name : card_names(p.state)) {
        if (name.beside)
            p.list.AddRectFilled(name.low - ImVec2(1, 0), name.high + ImVec2(1, 0),
                                 theme::with_alpha(theme::canvas, 0.8F), 2);
        draw_text(p.list, font, card_name_size, name.low, name_color(p, name), name.text);
    }
}

void draw_ghost(const Painter& p) {
    const Gesture& wire = p.state.gesture;
    if (wire.kind != Gesture::Kind::wire) return;
    const std::string& id = wire.from_output ? wire.from.node : wire.node;
    const std::string& port = wire.from_output ? wire.from.port : wire.port;
    for (const Card& card : p.state.layout.cards) {
        const Pin* pin = card.link_id() == id ? find_pin(card, port, wire.from_output) : nullptr;
        if (!pin) continue;
        const ImVec2 fixed = p.at(pin_at(card, *pin)), loose = ImGui::GetIO().MousePos;
        const Curve k =
            wire.from_output ? wire_curve(fixed, loose, p.zoom) : wire_curve(loose, fixed, p.zoom);
        draw_dashed(p.list, k, theme::of(wire.type), 2.5F, 7, 5);
        p.list.AddCircleFilled(loose, 4, theme::of(wire.type));
    }
}

void draw_box(const Painter& p) {
    if (p.state.gesture.kind != Gesture::Kind::box || !p.state.gesture.moved) return;
    const Extent box = Extent::between(p.state.gesture.start, ImGui::GetIO().MousePos);
    p.list.AddRectFilled(box.low, box.high, theme::with_alpha(theme::accent, 0.1F));
    p.list.AddRect(box.low, box.high, theme::accent);
}

void draw_hint(const Painter& p) {
    if (!p.state.document().nodes.empty()) return;
    constexpr std::string_view hint = "Space adds a node. Drop an image to start.";
    const float width = text_width(p.state.fonts.regular(16), 16, hint);
    ImVec2 at = p.view.corner + p.view.extent * 0.5F - ImVec2(width / 2, 8);
    if (!p.state.layout.cards.empty())
        at.y = p.at(p.state.layout.bounds.high).y + 24;  // below them
    draw_text(p.list, p.state.fonts.regular(16), 16, at, theme::text_dim, hint);
}

void draw_curve(ImDrawList& list, const Curve& k, ImU32 color, float thickness) {
    list.AddBezierCubic(k.a, k.b, k.c, k.d, color, thickness);
}

void draw_stroke(const State& state, ImDrawList& list) {
    const Gesture& g = state.gesture;
    const bool cuts = g.kind == Gesture::Kind::cut;
    const ImU32 color = cuts ? theme::error : theme::accent;
    for (const Gesture::Crossing& each : g.crossed)
        draw_curve(list, curve_on_screen(state.view, state.layout.wires[each.wire]), color, 2.5F);
    for (size_t i = 1; i < g.stroke.size(); ++i) {
        const ImVec2 a = to_screen(state.view, g.stroke[i - 1]);
        const ImVec2 b = to_screen(state.view, g.stroke[i]);
        draw_dashed(list, {a, a + (b - a) * (1 / 3.0F), a + (b - a) * (2 / 3.0F), b}, color, 2, 4,
                    4);
    }
    for (const Gesture::Crossing& each : g.crossed) {
        const ImVec2 at = to_screen(state.view, each.at);
        if (!cuts) {
            list.AddCircleFilled(at, 7, color);
            continue;
        }
        list.AddLine(at - ImVec2(5, 5), at + ImVec2(5, 5), color, 2);
        list.AddLine(at - ImVec2(5, -5), at + ImVec2(5, -5), color, 2);
    }
}

void draw_lasso(const State& state, ImDrawList& list) {
    const auto points =
        mapped<ImVec2>(state.gesture.stroke, [&](ImVec2 at) { return to_screen(state.view, at); });
    list.AddPolyline(points.data(), static_cast<int>(points.size()), theme::accent,
                     ImDrawFlags_Closed, 1.5F);
}

void outline(const State& state, ImDrawList& list, const Card& card) {
    const ImVec2 low = to_screen(state.view, card.at);
    list.AddRect(low - ImVec2(3, 3), low + card.size * state.view.zoom + ImVec2(3, 3),
                 theme::accent, 6 * state.view.zoom + 3, 0, 2);
}

void draw_lazy(const State& state, ImDrawList& list) {
    const Card& from = state.layout.cards[state.gesture.card];
    outline(state, list, from);
    const Hit& hit = state.hovered;
    ImVec2 start = to_screen(state.view, from.at + from.size * 0.5F), end = ImGui::GetIO().MousePos;
    ImU32 color = theme::accent;
    if (hit.on_card(state.layout) && hit.card != state.gesture.card) {
        const Card& to = state.layout.cards[hit.card];
        outline(state, list, to);
        if (const auto wire = lazy_wire(state, from, to)) {
            start = to_screen(state.view, pin_at(*wire->from, *wire->out));
            end = to_screen(state.view, pin_at(*wire->to, *wire->in));
            color = theme::of(wire->out->type);
        } else {
            color = theme::error;
        }
    }
    draw_dashed(list, wire_curve(start, end, state.view.zoom), color, 2.5F, 7, 5);
}

}  // namespace

void draw_graph(const State& state, ImDrawList& list) {
    const Painter p(state, list);
    draw_grid(p);
    draw_boxes(p);
    draw_wires(p);
    for (size_t i = 0; i < state.layout.cards.size(); ++i)
        if (p.sees(state.layout.card_boxes[i])) {
            const int first = list.VtxBuffer.Size;
            draw_card(p, i);
            if (p.fades(i)) fade(list, first);
        }
    draw_names(p);
    draw_ghost(p);
    draw_box(p);
    draw_hint(p);
}

void draw_gesture(const State& state, ImDrawList& list) {
    const Gesture& g = state.gesture;
    switch (g.kind) {
        case Gesture::Kind::cut:
        case Gesture::Kind::reroute:
            return draw_stroke(state, list);
        case Gesture::Kind::lasso:
            return draw_lasso(state, list);
        case Gesture::Kind::lazy:
            return draw_lazy(state, list);
        case Gesture::Kind::move:
            if (g.under_wire && *g.under_wire < state.layout.wires.size())
                draw_curve(list, curve_on_screen(state.view, state.layout.wires[*g.under_wire]),
                           theme::accent, 5);
            return;
        default:
            return;
    }
}

}  // namespace wrinkle::editor

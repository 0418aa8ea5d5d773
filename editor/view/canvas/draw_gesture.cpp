// Gesture feedback drawn over the cards: strokes and their crossings, the wire into which a dropped
// card would be inserted, the wire that a lazy drag would create.
#include <algorithm>

#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/lazy.h"
#include "editor/view/look/theme.h"

namespace wrinkle::editor {
namespace {

Curve on_screen(const View& view, const Wire& wire) {
    return wire_curve(to_screen(view, wire.start), to_screen(view, wire.end), view.zoom);
}

void draw_curve(ImDrawList& list, const Curve& k, ImU32 color, float thickness) {
    list.AddBezierCubic(k.a, k.b, k.c, k.d, color, thickness);
}

void draw_stroke(const State& state, ImDrawList& list) {
    const Gesture& g = state.gesture;
    const bool cuts = g.kind == Gesture::Kind::cut;
    const ImU32 color = cuts ? theme::error : theme::accent;
    for (const Gesture::Crossing& each : g.crossed)
        draw_curve(list, on_screen(state.view, state.layout.wires[each.wire]), color, 2.5F);
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
    std::vector<ImVec2> points;
    for (const ImVec2 at : state.gesture.stroke)
        points.push_back(to_screen(state.view, at));
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
            const Pin &out = wire->from->pins[wire->pins.out], &in = wire->to->pins[wire->pins.in];
            start = to_screen(state.view, pin_at(*wire->from, out));
            end = to_screen(state.view, pin_at(*wire->to, in));
            color = theme::of(out.type);
        } else {
            color = theme::error;
        }
    }
    draw_dashed(list, wire_curve(start, end, state.view.zoom), color, 2.5F, 7, 5);
}

}  // namespace

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
                draw_curve(list, on_screen(state.view, state.layout.wires[*g.under_wire]),
                           theme::accent, 5);
            return;
        default:
            return;
    }
}

}  // namespace wrinkle::editor

// Draws a reroute: a wire through the shape of its pin.
#include <algorithm>

#include "editor/view/canvas/painter.h"

namespace wrinkle::editor {

void draw_reroute(const Painter& p, size_t index) {
    const State& state = p.state;
    ImDrawList& list = p.list;
    const Card& card = state.layout.cards[index];
    const float zoom = state.view.zoom;
    const Pin& pin = card.pins.front();
    const ImU32 color = pin.known ? theme::of(pin.type) : theme::text_off;
    const ImVec2 start = to_screen(state.view, card.at + ImVec2(0, reroute_height / 2));
    const ImVec2 end = start + ImVec2(reroute_width * zoom, 0);
    const ImVec2 middle = (start + end) * 0.5F;
    list.AddLine(start, end, color, 2.5F * std::clamp(zoom, 0.5F, 1.5F));
    const Hit& hit = state.hovered;
    const bool hovered = hit.card == index && hit.on_card(state.layout);
    if (p.is_selected(index))
        list.AddCircle(middle, 12 * zoom, theme::accent, 0, 2);
    else if (hovered)
        list.AddCircle(middle, 12 * zoom, theme::text_dim);
    const bool wiring = state.gesture.kind == Gesture::Kind::wire;
    if (hovered || wiring)
        for (const ImVec2 at : {start, end})
            list.AddCircleFilled(at, 4 * zoom, color);
    list.AddCircleFilled(middle, 9.5F * zoom, theme::canvas);
    draw_pin(list, pin.type, middle, std::max(7 * zoom, 2.0F), color, card.pins.back().connected,
             theme::canvas);
}

}  // namespace wrinkle::editor

// Draws the canvas from back to front: grid, frames, wires, cards, dragged wire, selection box.
#include <algorithm>
#include <cmath>

#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/card_names.h"
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
        if (card.link_id() != id) continue;
        for (const Pin& pin : card.pins) {
            if (pin.port != port || pin.output != wire.from_output) continue;
            const ImVec2 fixed = p.at(pin_at(card, pin));
            const ImVec2 loose = ImGui::GetIO().MousePos;
            const Curve k = wire.from_output ? wire_curve(fixed, loose, p.zoom)
                                             : wire_curve(loose, fixed, p.zoom);
            draw_dashed(p.list, k, theme::of(wire.type), 2.5F, 7, 5);
            p.list.AddCircleFilled(loose, 4, theme::of(wire.type));
        }
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

}  // namespace

void draw_graph(const State& state, ImDrawList& list) {
    const Painter p(state, list);
    list.AddRectFilled(state.view.corner, state.view.corner + state.view.extent, theme::canvas);
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

}  // namespace wrinkle::editor

#include <algorithm>
#include <cmath>

#include "editor/canvas/canvas.h"
#include "editor/canvas/layout.h"
#include "editor/look/draw.h"

namespace wrinkle::editor {
namespace {

constexpr float pin_radius = 12;  // screen pixels, at any zoom
constexpr float wire_radius = 6;

bool within(ImVec2 at, ImVec2 low, ImVec2 high) {
    return at.x >= low.x && at.y >= low.y && at.x < high.x && at.y < high.y;
}

float squared(ImVec2 v) {
    return v.x * v.x + v.y * v.y;
}

Hit nearest_pin(const State& state, ImVec2 mouse) {
    Hit hit;
    float best = pin_radius * pin_radius;
    const auto& cards = state.layout.cards;
    for (size_t i = 0; i < cards.size(); ++i) {
        for (size_t k = 0; k < cards[i].pins.size(); ++k) {
            const ImVec2 at = to_screen(state.view, pin_at(cards[i], cards[i].pins[k]));
            if (squared(at - mouse) > best) continue;
            best = squared(at - mouse);
            hit = {Hit::Kind::pin, i, k};
        }
    }
    return hit;
}

// While a wire is drawn a whole row stands for its pin.
Hit row_of_wire(const State& state, size_t index, ImVec2 at) {
    const Card& card = state.layout.cards[index];
    for (size_t k = 0; k < card.pins.size(); ++k)
        if (std::fabs(card.pins[k].y - at.y) < row_height / 2 &&
            card.pins[k].output != state.gesture.from_output)
            return {Hit::Kind::pin, index, k};
    return {Hit::Kind::card, index, 0};
}

Hit part_of_card(const State& state, size_t index, ImVec2 mouse) {
    const Card& card = state.layout.cards[index];
    const ImVec2 at = to_canvas(state.view, mouse) - card.at;
    if (state.gesture.kind == Gesture::Kind::wire) return row_of_wire(state, index, at);
    if (at.y < header_height) return {Hit::Kind::header, index, 0};
    if (card.more_y >= 0 && at.y >= card.more_y) return {Hit::Kind::more, index, 0};
    if (state.view.zoom >= detail_zoom)
        for (size_t k = 0; k < card.fields.size(); ++k) {
            const Field& field = card.fields[k];
            if (within(at, {field.x, field.y}, {field.x + field.width, field.y + field_height}))
                return {Hit::Kind::field, index, k};
        }
    return {Hit::Kind::card, index, 0};
}

bool near_wire(const State& state, const Wire& wire, ImVec2 mouse) {
    const Curve curve = wire_curve(to_screen(state.view, wire.start),
                                   to_screen(state.view, wire.end), state.view.zoom);
    const ImVec2 a = curve.a, d = curve.d;
    const float reach = wire_radius + curve.b.x - a.x;
    if (mouse.x < std::min(a.x, d.x) - reach || mouse.x > std::max(a.x, d.x) + reach ||
        mouse.y < std::min(a.y, d.y) - reach || mouse.y > std::max(a.y, d.y) + reach)
        return false;
    ImVec2 last = a;
    for (int i = 1; i <= 32; ++i) {
        const ImVec2 next = curve.at(static_cast<float>(i) / 32);
        const ImVec2 along = next - last;
        const float length = squared(along);
        const ImVec2 to = mouse - last;
        const float k =
            length > 0 ? std::clamp((to.x * along.x + to.y * along.y) / length, 0.0F, 1.0F) : 0;
        if (squared(to - along * k) < wire_radius * wire_radius) return true;
        last = next;
    }
    return false;
}

}  // namespace

Hit pick(const State& state, ImVec2 mouse) {
    const Hit pin = nearest_pin(state, mouse);
    if (pin.kind == Hit::Kind::pin) return pin;
    const auto& cards = state.layout.cards;
    for (size_t i = cards.size(); i-- > 0;) {
        const ImVec2 low = to_screen(state.view, cards[i].at);
        if (within(mouse, low, low + cards[i].size * state.view.zoom))
            return part_of_card(state, i, mouse);
    }
    for (size_t i = state.layout.wires.size(); i-- > 0;)
        if (near_wire(state, state.layout.wires[i], mouse)) return {Hit::Kind::wire, 0, i};
    return {};
}

void name_targets(State& state) {
    const auto add = [&](std::string name, ImVec2 low, ImVec2 high) {
        state.targets.add(std::move(name), {low.x, low.y, high.x, high.y});
    };
    for (const Card& card : state.layout.cards) {
        const ImVec2 at = to_screen(state.view, card.at);
        const float zoom = state.view.zoom;
        add("node:" + card.id, at, at + ImVec2(card.size.x, header_height) * zoom);
        if (card.more_y >= 0)
            add("more:" + card.id, at + ImVec2(0, card.more_y) * zoom, at + card.size * zoom);
        for (const Pin& pin : card.pins) {
            const ImVec2 center = to_screen(state.view, pin_at(card, pin));
            add((pin.output ? "out:" : "pin:") + card.id + "." + pin.port, center - ImVec2(6, 6),
                center + ImVec2(6, 6));
        }
        if (zoom < detail_zoom) continue;
        for (const Field& field : card.fields) {
            const std::string lane = field.lanes > 1 ? "." + std::to_string(field.lane) : "";
            const ImVec2 low = at + ImVec2(field.x, field.y) * zoom;
            add("field:" + card.id + "." + field.port + lane, low,
                low + ImVec2(field.width, field_height) * zoom);
        }
    }
    for (const Wire& wire : state.layout.wires) {
        const ImVec2 start = to_screen(state.view, wire.start);
        const ImVec2 middle =
            wire_curve(start, to_screen(state.view, wire.end), state.view.zoom).at(0.5F);
        const std::string reader = wire.node.empty() ? Card::outputs_id : wire.node;
        add("wire:" + reader + "." + wire.port, middle - ImVec2(6, 6), middle + ImVec2(6, 6));
    }
    add("canvas", state.view.corner, state.view.corner + state.view.extent);
}

}  // namespace wrinkle::editor

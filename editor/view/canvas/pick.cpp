#include <algorithm>
#include <cmath>

#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"

namespace wrinkle::editor {
namespace {

constexpr float pin_radius = 12;  // screen pixels
constexpr float wire_radius = 6;

float squared(ImVec2 v) {
    return v.x * v.x + v.y * v.y;
}

// Returns the square of half size `radius` (screen pixels) around the pointer, in canvas units.
Extent around(const View& view, ImVec2 mouse, float radius) {
    return {to_canvas(view, mouse - ImVec2(radius, radius)),
            to_canvas(view, mouse + ImVec2(radius, radius))};
}

// The middle of a reroute moves it; its ends are pins.
bool is_handle(const CanvasState& canvas, const Card& card, ImVec2 mouse) {
    const ImVec2 at = to_canvas(canvas.view, mouse) - card.at;
    return card.reroute && Extent{{9, 0}, {23, reroute_height}}.contains(at);
}

// The topmost card under the pointer, or Hit::no_card.
size_t card_at(const CanvasState& canvas, ImVec2 mouse) {
    const auto& cards = canvas.layout.cards;
    const ImVec2 at = to_canvas(canvas.view, mouse);
    for (size_t i = cards.size(); i-- > 0;)
        if (cards[i].extent().contains(at)) return i;
    return Hit::no_card;
}

// Returns the nearest pin within 12 screen pixels. On a card, and if pins are not drawn, the radius
// shrinks with zooms below 1, so that the rest of a small card still moves it. A card hides the
// pins below it.
Hit nearest_pin(const CanvasState& canvas, ImVec2 mouse, size_t card) {
    Hit hit;
    const float zoom = canvas.view.zoom;
    const bool narrow = card != Hit::no_card || zoom < plain_zoom;
    const float radius = pin_radius * (narrow ? std::min(zoom, 1.0F) : 1.0F);
    float best = radius * radius;
    const auto& cards = canvas.layout.cards;
    const Extent near = around(canvas.view, mouse, radius);
    for (size_t i = card == Hit::no_card ? 0 : card; i < cards.size(); ++i) {
        if (!canvas.layout.card_boxes[i].touches(near)) continue;
        for (size_t k = 0; k < cards[i].pins.size(); ++k) {
            const ImVec2 at = to_screen(canvas.view, pin_at(cards[i], cards[i].pins[k]));
            if (squared(at - mouse) > best || is_handle(canvas, cards[i], mouse)) continue;
            best = squared(at - mouse);
            hit = {Hit::Kind::pin, i, k};
        }
    }
    return hit;
}

Hit part_of_card(const CanvasState& canvas, size_t index, ImVec2 mouse) {
    const Card& card = canvas.layout.cards[index];
    const ImVec2 at = to_canvas(canvas.view, mouse) - card.at;
    if (at.y < header_height) return {Hit::Kind::header, index, 0};
    if (card.more_y >= 0 && at.y >= card.more_y && at.y < card.more_y + row_height)
        return {Hit::Kind::more, index, 0};
    if (canvas.view.zoom >= detail_zoom)
        for (size_t k = 0; k < card.fields.size(); ++k) {
            const Field& field = card.fields[k];
            const ImVec2 low(field.x, field.y);
            if (Extent{low, low + ImVec2(field.width, field_height)}.contains(at))
                return {Hit::Kind::field, index, k};
        }
    return {Hit::Kind::card, index, 0};
}

bool near_wire(const CanvasState& canvas, const Wire& wire, ImVec2 mouse) {
    const Curve curve = curve_on_screen(canvas.view, wire);
    ImVec2 last = curve.a;
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

constexpr int steps = 32;

float across(ImVec2 a, ImVec2 b) {
    return a.x * b.y - a.y * b.x;
}

std::optional<ImVec2> meeting(ImVec2 a, ImVec2 b, ImVec2 c, ImVec2 d) {
    const ImVec2 along = b - a, other = d - c;
    const float area = across(along, other);
    if (area == 0) return std::nullopt;
    const float t = across(c - a, other) / area, u = across(c - a, along) / area;
    if (t < 0 || t > 1 || u < 0 || u > 1) return std::nullopt;
    return a + along * t;
}

}  // namespace

Hit pick(const State& state, ImVec2 mouse) {
    const size_t card = card_at(state, mouse);
    const Hit pin = nearest_pin(state, mouse, card);
    if (pin.kind == Hit::Kind::pin) return pin;
    if (card != Hit::no_card) return part_of_card(state, card, mouse);
    const Extent near = around(state.view, mouse, wire_radius);
    for (size_t i = state.layout.wires.size(); i-- > 0;)
        if (state.layout.wire_boxes[i].touches(near) &&
            near_wire(state, state.layout.wires[i], mouse))
            return {Hit::Kind::wire, 0, i};
    return pick_box(state, mouse).value_or(Hit{});
}

About about_hit(const CanvasState& canvas, const Hit& hit) {
    const Card& card = canvas.layout.cards[hit.card];
    constexpr float pin = 8;  // half the size of a pin, over the border
    float top = 0, tall = card.size.y;
    if (hit.kind == Hit::Kind::header) tall = header_height;
    if (hit.kind == Hit::Kind::field) top = card.fields[hit.part].y, tall = field_height;
    if (hit.kind == Hit::Kind::pin) top = card.pins[hit.part].y - row_height / 2, tall = row_height;
    return {to_screen(canvas.view, card.at + ImVec2(-pin, top)),
            to_screen(canvas.view, card.at + ImVec2(card.size.x + pin, top + tall)), true};
}

namespace {

TargetRect rect(ImVec2 low, ImVec2 high) {
    return {low.x, low.y, high.x, high.y};
}

// A square around a point.
TargetRect mark(ImVec2 at) {
    return rect(at - ImVec2(6, 6), at + ImVec2(6, 6));
}

std::optional<TargetRect> pin_target(const View& view, const Card& card, std::string_view port,
                                     bool output) {
    const Pin* pin = find_pin(card, port, output);
    return pin ? std::optional(mark(to_screen(view, pin_at(card, *pin)))) : std::nullopt;
}

// "amount", or for several numbers "scale.0".
std::optional<TargetRect> field_target(const View& view, const Card& card, std::string_view name) {
    if (view.zoom < detail_zoom) return std::nullopt;
    for (const Field& field : card.fields) {
        const std::string lane = field.lanes > 1 ? "." + std::to_string(field.lane) : "";
        if (field.port + lane != name) continue;
        const ImVec2 low = to_screen(view, card.at + ImVec2(field.x, field.y));
        return rect(low, low + ImVec2(field.width, field_height) * view.zoom);
    }
    return std::nullopt;
}

// "wire:sum.a": the middle of the wire to that input.
std::optional<TargetRect> wire_target(const CanvasState& canvas, const Card& reader,
                                      std::string_view port) {
    const Wire* wire = canvas.layout.wire_to({reader.link_id(), std::string(port)});
    return wire ? std::optional(mark(curve_on_screen(canvas.view, *wire).at(0.5F))) : std::nullopt;
}

const Card* card_named(const Layout& layout, std::string_view id) {
    if (const Card* card = layout.find(id)) return card;
    for (const Card::Kind kind : {Card::Kind::surface, Card::Kind::inputs, Card::Kind::outputs})
        if (const Card* card = layout.find(id, kind)) return card;
    return nullptr;
}

// "node:base", "pin:sum.a", "out:sum.gradient", "field:softer.amount",
// "wire:sum.a", "more:surface", "more:paint"
std::optional<TargetRect> canvas_target(const CanvasState& canvas, std::string_view name) {
    const size_t colon = name.find(':');
    if (colon == name.npos) return std::nullopt;
    const std::string_view what = name.substr(0, colon), rest = name.substr(colon + 1);
    const size_t dot = rest.find('.');
    const Card* card = card_named(canvas.layout, rest.substr(0, dot));
    if (!card) return std::nullopt;
    const ImVec2 at = to_screen(canvas.view, card->at);
    const float zoom = canvas.view.zoom;
    if (what == "node") return rect(at, at + ImVec2(card->size.x, header_height) * zoom);
    if (what == "more" && card->more_y >= 0)
        return rect(at + ImVec2(0, card->more_y) * zoom,
                    at + ImVec2(card->size.x, card->more_y + row_height) * zoom);
    if (dot == rest.npos) return std::nullopt;
    const std::string_view part = rest.substr(dot + 1);
    if (what == "pin" || what == "out") return pin_target(canvas.view, *card, part, what == "out");
    if (what == "wire") return wire_target(canvas, *card, part);
    return what == "field" ? field_target(canvas.view, *card, part) : std::nullopt;
}

}  // namespace

void name_targets(State& state) {
    state.targets.set_canvas(
        [&state](const std::string& name) { return canvas_target(state, name); });
    state.targets.add("canvas", rect(state.view.corner, state.view.corner + state.view.extent));
}

Curve curve_of(const Wire& wire) {
    return wire_curve(wire.start, wire.end, 1);
}

Curve curve_on_screen(const View& view, const Wire& wire) {
    return wire_curve(to_screen(view, wire.start), to_screen(view, wire.end), view.zoom);
}

std::optional<ImVec2> crossing(const Layout& layout, size_t wire, ImVec2 a, ImVec2 b) {
    if (!layout.wire_boxes[wire].touches(Extent::between(a, b))) return std::nullopt;
    const Curve curve = curve_of(layout.wires[wire]);
    ImVec2 last = curve.a;
    for (int i = 1; i <= steps; ++i) {
        const ImVec2 next = curve.at(static_cast<float>(i) / steps);
        if (const auto at = meeting(last, next, a, b)) return at;
        last = next;
    }
    return std::nullopt;
}

std::optional<size_t> wire_under(const Layout& layout, const Card& card) {
    const Extent box = card.extent();
    const ImVec2 middle = card.at + card.size * 0.5F;
    std::optional<size_t> found;
    float best = 0;
    for (size_t i = 0; i < layout.wires.size(); ++i) {
        const Wire& wire = layout.wires[i];
        if (wire.node == card.id || wire.from.node == card.id) continue;
        if (!layout.wire_boxes[i].touches(box)) continue;
        const Curve curve = curve_of(wire);
        for (int k = 0; k <= steps; ++k) {
            const ImVec2 at = curve.at(static_cast<float>(k) / steps);
            if (!box.touches({at, at})) continue;
            const float distance = std::hypot(at.x - middle.x, at.y - middle.y);
            if (found && distance >= best) continue;
            best = distance;
            found = i;
        }
    }
    return found;
}

}  // namespace wrinkle::editor

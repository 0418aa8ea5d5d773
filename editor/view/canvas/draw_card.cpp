#include <algorithm>
#include <cmath>

#include "editor/model/words.h"
#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/make_card.h"
#include "editor/view/canvas/painter.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/preview/knot_values.h"
#include "lower/mute.h"

namespace wrinkle::editor {
namespace {

ImU32 color_of(const Diagnostic& problem) {
    return problem.severity == Severity::error ? theme::error : theme::warn;
}

void draw_badge(const Painter& p, ImVec2 center, float size, const Diagnostic& problem) {
    if (problem.severity == Severity::error)
        draw_error(p.list, center, size, theme::error);
    else
        draw_warning(p.list, center, size, theme::warn);
}

void explain(const Painter& p, const Diagnostic& problem) {
    show_tooltip(about_hit(p.state, p.state.hovered), p.state.fonts.bold(16),
                 sentence(problem.message), sentence(problem.expected));
}

void draw_field(const Painter& p, const Card& card, const Field& field, bool hovered,
                const Diagnostic* fault) {
    const float z = p.zoom;
    const ImVec2 low = p.at(card.at + ImVec2(field.x, field.y));
    const ImVec2 high = low + ImVec2(field.width, field_height) * z;
    p.list.AddRectFilled(low, high, theme::field, 4 * z);
    if (field.part > 0) {
        const float x = low.x + (high.x - low.x) * field.part;
        const float round = std::min(4 * z, (x - low.x) / 2);
        p.list.AddRectFilled(low, {x, high.y}, theme::accent_soft, round);
        p.list.AddRectFilled({low.x + 3 * z, high.y - 2 * z}, {std::max(x, low.x + 3 * z), high.y},
                             theme::accent);
    }
    if (field.shows == Field::Shows::strip) draw_ramp_colors(p.list, low, high, card.strip);
    if (field.shows == Field::Shows::curve)
        draw_curve_values(p.list, low + ImVec2(0, 3) * z, high - ImVec2(0, 3) * z, card.values,
                          range_of_curve(card.values, {}), theme::accent);
    if (fault)
        p.list.AddRect(low, high, color_of(*fault), 4 * z, 0, 1.6F);
    else
        p.list.AddRect(low, high, hovered ? theme::accent : theme::control, 4 * z);
    if (fault && hovered) explain(p, *fault);
    const float pad = 7 * z, y = low.y + 2.5F * z;
    if (!field.name.empty()) p.text({low.x + pad, y}, card_text::body, theme::text_dim, field.name);
    const float end = high.x - pad - (field.listed ? 12 * z : 0);
    p.text({end, y}, card_text::body_right, theme::text, field.value);
    if (!field.listed) return;
    const ImVec2 tip(high.x - 11 * z, (low.y + high.y) / 2 + 2 * z);
    const ImVec2 chevron[] = {tip + ImVec2(-4, -4) * z, tip, tip + ImVec2(4, -4) * z};
    p.list.AddPolyline(chevron, 3, theme::text_dim, 0, 1.5F * z);
}

void draw_pins(const Painter& p, size_t index) {
    const Card& card = p.state.layout.cards[index];
    const Hit& hit = p.state.hovered;
    const bool wiring = p.state.gesture.kind == Gesture::Kind::wire;
    for (size_t i = 0; i < card.pins.size(); ++i) {
        const Pin& pin = card.pins[i];
        const ImVec2 at = p.at(pin_at(card, pin));
        const bool fits = !wiring || wire_fits(p.state, p.state.gesture, card, pin);
        const bool near = hit.kind == Hit::Kind::pin && hit.card == index && hit.part == i;
        const float unit = (wiring && fits ? 8 : near ? 7 : 6) * std::max(p.zoom, 0.4F);
        ImU32 color = pin.known ? theme::of(pin.type) : theme::text_off;
        if (!fits) color = theme::with_alpha(color, 0.3F);
        if (p.details) p.list.AddCircleFilled(at, unit + 3 * p.zoom, theme::node);
        draw_pin(p.list, pin.type, at, unit, color, pin.connected, theme::node);
        if (pin.in_field && p.details) continue;
        const ImVec2 label = at + ImVec2(pin.output ? -13 : 13, -8) * p.zoom;
        p.text(label, pin.output ? card_text::body_right : card_text::body, theme::text, pin.label);
    }
}

const Pin* main_pin(const Card& card) {
    for (const Pin& pin : card.pins)
        if (pin.output || card.kind == Card::Kind::outputs) return &pin;
    return nullptr;
}

void draw_header(const Painter& p, size_t index, ImVec2 low, ImVec2 high) {
    const Card& card = p.state.layout.cards[index];
    const float z = p.zoom;
    p.list.AddRectFilled(low, {high.x, low.y + header_height * z}, theme::header, 6 * z,
                         ImDrawFlags_RoundCornersTop);
    float left = 10;
    if (const Pin* pin = main_pin(card)) {
        draw_pin(p.list, pin->type, low + ImVec2(16, 14) * z, 5.5F * z,
                 pin->known ? theme::of(pin->type) : theme::text_off, true, theme::header);
        left = name_left;
    }
    const bool previewed = card.kind == Card::Kind::node && p.view.preview_request.node == card.id;
    p.text(low + ImVec2(left, 6) * z, card_text::bold, card.muted ? theme::text_off : theme::text,
           card.name);
    if (card.muted)
        p.list.AddLine(low + ImVec2(left, 14) * z, low + ImVec2(left + card.name_width, 14) * z,
                       theme::text_off, 1);
    if (const Diagnostic* problem = p.issue(index)) {
        const ImVec2 center(high.x - 15 * z, low.y + 14 * z);
        draw_badge(p, center, std::max(16 * z, 8.0F), *problem);
        const ImVec2 off = ImGui::GetIO().MousePos - center;
        if (p.state.hovered.card == index && p.state.hovered.kind == Hit::Kind::header &&
            std::max(std::fabs(off.x), std::fabs(off.y)) < 12)
            explain(p, *problem);
    } else if (previewed) {
        draw_icon(p.list, "preview-node", {high.x - 15 * z, low.y + 14 * z}, theme::accent);
    } else {
        p.text({high.x - 10 * z, low.y + 7 * z}, card_text::small_right, theme::text_dim,
               card.title);
    }
}

ImU32 plain_color(const Painter& p, const Card& card) {
    const Price* price = p.view.heat ? p.price(card) : nullptr;
    return price ? heat_color(p.heat(*price)).ground : theme::header;
}

// "8x" in the lower right corner of a magnified preview.
void draw_magnification(const Painter& p, ImVec2 corner) {
    const std::string words = std::to_string(NodePreviews::magnification) + "\u00d7";
    const ImVec2 low = corner - ImVec2(26, 19) * p.zoom;
    p.list.AddRectFilled(low, corner, theme::with_alpha(theme::node, 0.8F), 3 * p.zoom);
    p.text(corner - ImVec2(5, 17) * p.zoom, card_text::small_right, theme::text, words);
}

// The node preview, cropped to the card's width; at half opacity if the current graph has no
// running shader and the preview is of an earlier graph.
void draw_node_preview(const Painter& p, const Card& card, ImVec2 low, ImVec2 high) {
    if (card.preview_y < 0) return;
    const ImVec2 from(low.x + field_inset * p.zoom, low.y + card.preview_y * p.zoom);
    const ImVec2 to(high.x - field_inset * p.zoom, from.y + node_preview_height * p.zoom);
    const NodeFeed& feed = p.state.node_feed;
    if (const auto at = preview_place(feed, card.id)) {
        const float wide = (to.x - from.x) / (to.y - from.y) * NodePreviews::height;
        const float u = (at->u1 - at->u0) * (1 - std::min(wide / NodePreviews::width, 1.0F)) / 2;
        const float v = (at->v1 - at->v0) * (1 - std::min(NodePreviews::width / wide, 1.0F)) / 2;
        const ImU32 tint = theme::with_alpha(IM_COL32_WHITE, p.state.built.running() ? 1 : 0.5F);
        p.list.AddImageRounded(texture_id(feed.atlas.texture()), from, to, {at->u0 + u, at->v1 - v},
                               {at->u1 - u, at->v0 + v}, tint, 3 * p.zoom);
    }
    p.list.AddRect(from, to, theme::border, 3 * p.zoom);
    if (feed.previews.magnified.contains(card.id)) draw_magnification(p, to);
}

// The last row: cost of the node, if known.
void draw_cost(const Painter& p, const Card& card, ImVec2 high, bool hovered) {
    const Price* price = p.price(card);
    if (!price) return;
    const Costs& costs = *p.state.costs();
    const std::string words = in_words(*price, costs.estimated);
    const float z = p.zoom;
    const ImVec2 end = high - ImVec2(10, 17) * z;
    const float width =
        hovered || p.view.heat ? magnified_width(p.state.fonts, card_text::small, words) : 0;
    const ImVec2 low = end - ImVec2(width + 6, 1) * z, edge = end + ImVec2(5, 15) * z;
    if (hovered && ImGui::IsMouseHoveringRect(low, edge))
        show_tooltip({p.at(card.at + ImVec2(0, card.size.y - cost_height)), high, true},
                     p.state.fonts.bold(16), words, in_full(*price, costs));
    ImU32 color = theme::text_dim;
    if (p.view.heat) {
        const HeatColor heat = heat_color(p.heat(*price));
        p.list.AddRectFilled(low, edge, heat.ground, 4 * z);
        color = heat.text;
    }
    p.text(end, card_text::small_right, color, words);
}

// At low zoom: a rectangle, a badge for diagnostics, and the selection.
void draw_plain(const Painter& p, size_t index, ImVec2 low, ImVec2 high, bool selected) {
    p.list.AddRectFilled(low, high, selected ? theme::accent : theme::line);
    const ImVec2 edge(selected ? 2.0F : 1.0F, selected ? 2.0F : 1.0F);
    if (high.x - low.x > 2 * edge.x + 1 && high.y - low.y > 2 * edge.y + 1)
        p.list.AddRectFilled(low + edge, high - edge, plain_color(p, p.state.layout.cards[index]));
    if (const Diagnostic* problem = p.issue(index))
        draw_badge(p, {high.x - 5, low.y + 5}, 8, *problem);
}

void draw_outline(const Painter& p, const Card& card, ImVec2 low, ImVec2 high, bool selected,
                  bool hovered) {
    const float radius = 6 * p.zoom;
    if (selected)
        p.list.AddRect(low - ImVec2(2, 2), high + ImVec2(2, 2),
                       theme::with_alpha(theme::accent, p.is_primary(card) ? 0.4F : 0.2F),
                       radius + 2, 0, 3);
    const ImU32 color = selected ? theme::accent : hovered ? theme::text_dim : theme::line;
    p.list.AddRect(low, high, color, radius, 0, selected ? 2 : 1);
}

// Hatches a card with a type that is not installed.
void draw_hatch(const Painter& p, ImVec2 low, ImVec2 high) {
    p.list.PushClipRect(low + ImVec2(1, 0), high - ImVec2(1, 1), true);
    const float tall = high.y - low.y;
    for (float x = low.x - tall; x < high.x; x += std::max(8 * p.zoom, 4.0F))
        p.list.AddLine({x, high.y}, {x + tall, low.y}, theme::border);
    p.list.PopClipRect();
}

// The value that passes through a muted node.
void draw_passage(const Painter& p, const Card& card) {
    const Pin* output = main_pin(card);
    const uint32_t out =
        card.type && output ? card.type->find_output(output->port) : NodeType::none;
    if (out == NodeType::none) return;
    const auto input_of = [&](uint32_t port) {
        return find_pin(card, card.type->ports[port].name, false);
    };
    const uint32_t in = passed_input(*card.type, out, [&](uint32_t port) {
        const Pin* pin = input_of(port);
        return pin && pin->connected;
    });
    const Pin* input = in == NodeType::none ? nullptr : input_of(in);
    if (!input) return;
    const ImVec2 from = p.at(pin_at(card, *input)), to = p.at(pin_at(card, *output));
    draw_dashed(p.list, {from, from + (to - from) * 0.33F, from + (to - from) * 0.67F, to},
                theme::text_dim, 1.5F, 6, 4);
}

void draw_body(const Painter& p, size_t index, ImVec2 low, ImVec2 high, bool hovered) {
    const Card& card = p.state.layout.cards[index];
    const Hit& hit = p.state.hovered;
    const ImVec2 under(low.x, low.y + header_height * p.zoom);
    if (card.kind == Card::Kind::node && !card.type) draw_hatch(p, under, high);
    const bool faulty = p.issue(index) != nullptr;
    if (p.details)
        for (size_t i = 0; i < card.fields.size(); ++i)
            draw_field(p, card, card.fields[i],
                       hovered && hit.kind == Hit::Kind::field && hit.part == i,
                       faulty ? p.fault(card, card.fields[i].port) : nullptr);
    draw_node_preview(p, card, low, high);
    if (p.details || p.view.heat) draw_cost(p, card, high, hovered);
    if (!card.muted) return;
    p.list.AddRectFilled(under + ImVec2(1, 0), high - ImVec2(1, 1),
                         theme::with_alpha(theme::node, 0.55F), 5 * p.zoom,
                         ImDrawFlags_RoundCornersBottom);
    draw_passage(p, card);
}

}  // namespace

void draw_card(const Painter& p, size_t index) {
    const Card& card = p.state.layout.cards[index];
    if (card.reroute) return draw_reroute(p, index);
    const ImVec2 low = p.at(card.at), high = low + card.size * p.zoom;
    const bool selected = p.is_selected(index);
    if (p.plain) return draw_plain(p, index, low, high, selected);
    const Hit& hit = p.state.hovered;
    const bool hovered = (hit.card == index && hit.on_card(p.state.layout)) ||
                         (card.kind == Card::Kind::node && card.id == p.state.code.hovered);
    const float radius = 6 * p.zoom;
    const bool held = selected && p.state.gesture.kind == Gesture::Kind::move;
    const ImVec2 fall = held ? ImVec2(4, 6) : ImVec2(2, 3);
    p.list.AddRectFilled(low + fall, high + fall, theme::shadow, radius);
    p.list.AddRectFilled(low, high, theme::node, radius);
    draw_header(p, index, low, high);
    draw_body(p, index, low, high, hovered);
    draw_outline(p, card, low, high, selected, hovered);
    draw_pins(p, index);
    if (!p.details || card.more_y < 0) return;
    const bool near = hovered && hit.kind == Hit::Kind::more;
    p.text(low + ImVec2(13, card.more_y + 4) * p.zoom, card_text::small,
           near ? theme::text : theme::text_dim, card.more);
}

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

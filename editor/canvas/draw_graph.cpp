#include <algorithm>
#include <cmath>

#include "editor/canvas/canvas.h"
#include "editor/canvas/field.h"
#include "editor/canvas/layout.h"
#include "editor/look/draw.h"
#include "editor/look/theme.h"
#include "lower/conversion.h"

namespace wrinkle::editor {
namespace {

// What the parts of the drawing share.
struct Painter {
    const State& state;
    ImDrawList& list;
    const View& view;
    float zoom;
    bool details;  // zoomed in far enough for rows and fields
    bool words;

    ImFont* font(float size, bool bold = false) const {
        return bold ? state.fonts.bold(size * zoom) : state.fonts.regular(size * zoom);
    }
    void text(ImVec2 at, float size, ImU32 color, std::string_view what, bool bold = false,
              bool right = false) const {
        if (size * zoom >= 6)
            draw_text(list, font(size, bold), size * zoom, at, color, what, right);
    }
    std::string cut(float size, std::string_view what, float width, bool bold = false) const {
        return fitting(font(size, bold), size * zoom, what, width * zoom);
    }
};

void draw_grid(const Painter& p) {
    if (p.zoom < 0.5F) return;
    const float step = 32 * p.zoom;
    const ImVec2 end = p.view.corner + p.view.extent;
    const auto first = [&](float pan) { return std::fmod(std::fmod(pan, step) + step, step); };
    for (float y = p.view.corner.y + first(p.view.pan.y); y < end.y; y += step)
        for (float x = p.view.corner.x + first(p.view.pan.x); x < end.x; x += step)
            p.list.AddRectFilled({x - 1, y - 1}, {x + 1, y + 1}, theme::grid);
}

// The pill on a wire that says what happens to the value on its way.
void draw_conversion(const Painter& p, const Wire& wire, ImVec2 at) {
    const Conversion what = conversion(wire.from_type, wire.to_type);
    if (what == Conversion::same || what == Conversion::rename || p.zoom < 0.5F) return;
    const ImVec2 half(25 * p.zoom, 11 * p.zoom);
    const ImU32 edge = what == Conversion::illegal ? theme::error : theme::line;
    p.list.AddRectFilled(at - half, at + half, theme::node, half.y);
    p.list.AddRect(at - half, at + half, edge, half.y);
    const float unit = 5 * p.zoom;
    draw_pin(p.list, wire.from_type, at - ImVec2(14 * p.zoom, 0), unit, theme::of(wire.from_type),
             true, theme::node);
    draw_pin(p.list, wire.to_type, at + ImVec2(14 * p.zoom, 0), unit, theme::of(wire.to_type), true,
             theme::node);
    if (what == Conversion::illegal) {
        p.list.AddLine(at - ImVec2(4, 4), at + ImVec2(4, 4), edge, 2);
        p.list.AddLine(at - ImVec2(4, -4), at + ImVec2(4, -4), edge, 2);
    } else {
        p.list.AddLine(at - ImVec2(4 * p.zoom, 0), at + ImVec2(4 * p.zoom, 0), theme::text_dim,
                       1.5F);
        p.list.AddTriangleFilled(at + ImVec2(5 * p.zoom, 0), at + ImVec2(1, -3) * p.zoom,
                                 at + ImVec2(1, 3) * p.zoom, theme::text_dim);
    }
}

bool belongs_to_selection(const View& view, const Wire& wire) {
    return view.selected.contains(wire.from.node) ||
           (!wire.node.empty() && view.selected.contains(wire.node));
}

void draw_wire(const Painter& p, const Wire& wire, bool hovered) {
    const ImVec2 start = to_screen(p.view, wire.start), end = to_screen(p.view, wire.end);
    const Curve k = wire_curve(start, end, p.zoom);
    const bool chosen = p.view.selected_wire && p.view.selected_wire->node == wire.node &&
                        p.view.selected_wire->port == wire.port;
    const float thickness = (hovered                              ? 4
                             : belongs_to_selection(p.view, wire) ? 3
                                                                  : 2.5F) *
                            std::clamp(p.zoom, 0.5F, 1.5F);
    const bool illegal =
        wire.known && conversion(wire.from_type, wire.to_type) == Conversion::illegal;
    ImU32 color = wire.known ? theme::of(wire.from_type) : theme::text_off;
    if (chosen) color = theme::accent;
    if (illegal) {
        draw_dashed(p.list, k, theme::error, thickness, 6, 4);
    } else {
        if (p.zoom >= 0.6F) p.list.AddBezierCubic(k.a, k.b, k.c, k.d, theme::canvas, thickness + 3);
        p.list.AddBezierCubic(k.a, k.b, k.c, k.d, color, thickness, p.zoom < 0.35F ? 8 : 0);
    }
    if (wire.known) draw_conversion(p, wire, k.at(0.5F));
}

void draw_field(const Painter& p, const Card& card, const Node& node, const Field& field,
                bool hovered) {
    const Port& port = card.type->ports[field.index];
    const float z = p.zoom;
    const ImVec2 low = to_screen(p.view, card.at + ImVec2(field.x, field.y));
    const ImVec2 high = low + ImVec2(field.width, field_height) * z;
    p.list.AddRectFilled(low, high, theme::field, 4 * z);
    const double value = numbers_at(node, port)[static_cast<size_t>(field.lane)];
    if (field.lanes > 0 && port.has_soft_range()) {
        const double part = (value - port.soft_min) / (port.soft_max - port.soft_min);
        const float x = low.x + (high.x - low.x) * static_cast<float>(std::clamp(part, 0.0, 1.0));
        p.list.AddRectFilled(low, {x, high.y}, theme::accent_soft, 4 * z);
        p.list.AddRectFilled({low.x + 2 * z, high.y - 2 * z}, {x, high.y}, theme::accent);
    }
    p.list.AddRect(low, high, hovered ? theme::accent : theme::control, 4 * z);
    const std::string shown = field.lanes > 1 ? shown_number(value, port) : shown_value(node, port);
    const float pad = 7 * z, y = low.y + 2.5F * z;
    const bool named = field.lanes <= 1;
    const float room = field.width - 14;
    const bool listed = port.kind == Port::Kind::choice || port.type == PortType::image_;
    const float value_width = text_width(p.font(16), 16 * z, shown) / z + (listed ? 12.0F : 0.0F);
    if (named && room - value_width > 20)
        p.text({low.x + pad, y}, 16, theme::text_dim, p.cut(16, port.name, room - value_width - 6));
    p.text({high.x - pad - (listed ? 12 * z : 0), y}, 16, theme::text,
           p.cut(16, shown, room - (listed ? 12 : 0)), false, true);
    if (!listed) return;
    const ImVec2 tip(high.x - 9 * z, (low.y + high.y) / 2 + 2 * z);
    const ImVec2 chevron[] = {tip + ImVec2(-4, -4) * z, tip, tip + ImVec2(4, -4) * z};
    p.list.AddPolyline(chevron, 3, theme::text_dim, 0, 1.5F);
}

bool has_field(const Card& card, const Pin& pin) {
    return !pin.output && std::any_of(card.fields.begin(), card.fields.end(), [&](const Field& f) {
        return f.port == pin.port && f.lanes <= 1;
    });
}

void draw_pins(const Painter& p, const Card& card, ImU32 ground) {
    const bool wiring = p.state.gesture.kind == Gesture::Kind::wire;
    for (size_t i = 0; i < card.pins.size(); ++i) {
        const Pin& pin = card.pins[i];
        const ImVec2 at = to_screen(p.view, pin_at(card, pin));
        const bool fits = !wiring || wire_fits(p.state, p.state.gesture, card, pin);
        const float unit = (wiring && fits ? 8 : 6) * std::max(p.zoom, 0.4F);
        ImU32 color = pin.known ? theme::of(pin.type) : theme::text_off;
        if (!fits) color = theme::with_alpha(color, 0.3F);
        if (p.details)
            p.list.AddCircleFilled(at, unit + 3 * p.zoom, theme::with_alpha(ground, 0.9F));
        draw_pin(p.list, pin.type, at, unit, color, pin.connected, ground);
        if (!p.details || has_field(card, pin)) continue;
        const ImVec2 label = at + ImVec2(pin.output ? -13 : 13, -8) * p.zoom;
        p.text(label, 16, theme::text, p.cut(16, pin.port, card.size.x - 30), false, pin.output);
    }
}

struct Trouble {
    bool any = false, error = false;
};

Trouble trouble_of(const State& state, const Card& card) {
    Trouble trouble;
    if (card.kind != Card::Kind::node) return trouble;
    for (const Diagnostic& problem : state.built.problems.list()) {
        if (problem.node.substr(0, problem.node.find('/')) != card.id) continue;
        trouble.any = true;
        trouble.error |= problem.severity == Severity::error;
    }
    return trouble;
}

const Pin* main_pin(const Card& card) {
    for (const Pin& pin : card.pins)
        if (pin.output || card.kind == Card::Kind::outputs) return &pin;
    return nullptr;
}

void draw_header(const Painter& p, const Card& card, ImVec2 low, ImVec2 high) {
    const float z = p.zoom, radius = 6 * z;
    p.list.AddRectFilled(low, {high.x, low.y + header_height * z}, theme::header, radius,
                         p.details ? ImDrawFlags_RoundCornersTop : ImDrawFlags_RoundCornersAll);
    float left = 10;
    if (const Pin* pin = main_pin(card)) {
        draw_pin(p.list, pin->type, low + ImVec2(16, 14) * z, 5.5F * z,
                 pin->known ? theme::of(pin->type) : theme::text_off, true, theme::header);
        left = 29;
    }
    const Trouble trouble = trouble_of(p.state, card);
    const float right = trouble.any ? 28 : 10;
    const std::string name = card.kind == Card::Kind::outputs ? "output" : card.id;
    const float id_width = text_width(p.font(16, true), 16 * z, name) / z;
    const float room = card.size.x - left - right;
    p.text(low + ImVec2(left, 6) * z, 16, card.muted ? theme::text_off : theme::text,
           p.cut(16, name, room, true), true);
    if (card.muted)
        p.list.AddLine(low + ImVec2(left, 14) * z,
                       low + ImVec2(left + std::min(id_width, room), 14) * z, theme::text_off, 1);
    if (room - id_width > 40 && p.details)
        p.text({high.x - right * z, low.y + 7 * z}, 14, theme::text_dim,
               p.cut(14, card.label, room - id_width - 12), false, true);
    if (trouble.any)
        draw_warning(p.list, {high.x - 15 * z, low.y + 14 * z}, std::max(16 * z, 8.0F),
                     trouble.error ? theme::error : theme::warn);
}

void draw_card(const Painter& p, size_t index) {
    const Card& card = p.state.layout.cards[index];
    const ImVec2 low = to_screen(p.view, card.at), high = low + card.size * p.zoom;
    const ImVec2 end = p.view.corner + p.view.extent;
    if (high.x < p.view.corner.x || high.y < p.view.corner.y || low.x > end.x || low.y > end.y)
        return;
    const float radius = 6 * p.zoom;
    const bool selected = p.view.selected.contains(card.id);
    const Hit& hit = p.state.hovered;
    const bool hovered =
        hit.card == index && hit.kind != Hit::Kind::nothing && hit.kind != Hit::Kind::wire;
    p.list.AddRectFilled(low + ImVec2(2, 3), high + ImVec2(2, 3), IM_COL32(0, 0, 0, 71), radius);
    p.list.AddRectFilled(low, high, theme::node, radius);
    draw_header(p, card, low, high);
    if (selected)
        p.list.AddRect(low - ImVec2(2, 2), high + ImVec2(2, 2),
                       theme::with_alpha(theme::accent, 0.2F), radius + 2, 0, 3);
    p.list.AddRect(low, high,
                   selected  ? theme::accent
                   : hovered ? theme::text_dim
                             : theme::line,
                   radius, 0, selected ? 2 : 1);
    const Node* node = p.state.document().find(card.id);
    if (p.details && node && card.type)
        for (size_t i = 0; i < card.fields.size(); ++i)
            draw_field(p, card, *node, card.fields[i],
                       hovered && hit.kind == Hit::Kind::field && hit.part == i);
    if (p.words) draw_pins(p, card, theme::node);
    if (p.details && card.more_y >= 0) {
        const bool all = card.kind == Card::Kind::surface ? p.view.all_surface : p.view.all_outputs;
        p.text(low + ImVec2(13, card.more_y + 4) * p.zoom, 14, theme::text_dim,
               all ? "fewer" : "more...");
    }
}

void draw_ghost(const Painter& p) {
    const Gesture& wire = p.state.gesture;
    if (wire.kind != Gesture::Kind::wire) return;
    const std::string& id = wire.from_output ? wire.from.node : wire.node;
    const std::string& port = wire.from_output ? wire.from.port : wire.port;
    for (const Card& card : p.state.layout.cards) {
        const std::string own = card.kind == Card::Kind::outputs ? "" : card.id;
        if (own != id) continue;
        for (const Pin& pin : card.pins) {
            if (pin.port != port || pin.output != wire.from_output) continue;
            const ImVec2 fixed = to_screen(p.view, pin_at(card, pin));
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
    const ImVec2 a = p.state.gesture.start, b = ImGui::GetIO().MousePos;
    const ImVec2 low(std::min(a.x, b.x), std::min(a.y, b.y));
    const ImVec2 high(std::max(a.x, b.x), std::max(a.y, b.y));
    p.list.AddRectFilled(low, high, theme::with_alpha(theme::accent, 0.1F));
    p.list.AddRect(low, high, theme::accent);
}

void draw_frames(const Painter& p) {
    const auto draw = [&](const Box& box, bool note) {
        const ImVec2 low =
            to_screen(p.view, {static_cast<float>(box.rect.x), static_cast<float>(box.rect.y)});
        const ImVec2 high =
            low + ImVec2(static_cast<float>(box.rect.width), static_cast<float>(box.rect.height)) *
                      p.zoom;
        p.list.AddRectFilled(low, high,
                             note ? theme::bar : theme::with_alpha(theme::accent, 0.045F), 8);
        if (!note) p.list.AddRect(low, high, theme::border, 8);
        if (note) p.list.AddRectFilled(low, {low.x + 3, high.y}, theme::control);
        draw_text(p.list, p.state.fonts.bold(16), std::max(16 * p.zoom, 12.0F),
                  low + ImVec2(16, 10) * p.zoom, theme::text_dim, box.text);
    };
    for (const Box& box : p.state.document().frames)
        draw(box, false);
    for (const Box& box : p.state.document().notes)
        draw(box, true);
}

void draw_hint(const Painter& p) {
    if (!p.state.document().nodes.empty()) return;
    constexpr std::string_view hint = "Space adds a node. Drop an image to start.";
    const float width = text_width(p.state.fonts.regular(16), 16, hint);
    const ImVec2 at = p.view.corner + p.view.extent * 0.5F - ImVec2(width / 2, 8);
    draw_text(p.list, p.state.fonts.regular(16), 16, at, theme::text_dim, hint);
}

}  // namespace

void draw_graph(const State& state, ImDrawList& list) {
    const float zoom = state.view.zoom;
    const Painter p{state, list, state.view, zoom, zoom >= detail_zoom, zoom >= 0.35F};
    list.AddRectFilled(state.view.corner, state.view.corner + state.view.extent, theme::canvas);
    draw_grid(p);
    draw_frames(p);
    for (size_t i = 0; i < state.layout.wires.size(); ++i)
        draw_wire(p, state.layout.wires[i],
                  state.hovered.kind == Hit::Kind::wire && state.hovered.part == i);
    for (size_t i = 0; i < state.layout.cards.size(); ++i)
        draw_card(p, i);
    draw_ghost(p);
    draw_box(p);
    draw_hint(p);
}

}  // namespace wrinkle::editor

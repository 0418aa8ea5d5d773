#include "editor/canvas/canvas.h"
#include "editor/document/refresh.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/field.h"
#include "editor/canvas/layout.h"
#include "editor/document/edits.h"
#include "editor/look/draw.h"
#include "editor/panels/popups.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

using Kind = Gesture::Kind;

constexpr float threshold = 4;  // pixels before a press becomes a drag

std::string merge_key(const State& state) {
    return "gesture " + std::to_string(state.history.serial());
}

void begin(State& state, Kind kind) {
    state.gesture = {};
    state.gesture.kind = kind;
    state.gesture.start = ImGui::GetIO().MousePos;
    state.gesture.merge = merge_key(state);
}

void begin_wire(State& state, const Card& card, const Pin& pin) {
    begin(state, Kind::wire);
    Gesture& wire = state.gesture;
    const std::string id = card.kind == Card::Kind::outputs ? "" : card.id;
    if (!pin.output) {
        wire.node = id;
        wire.port = pin.port;
    }
    wire.from_output = pin.output;
    wire.type = pin.type;
    if (pin.output) {
        wire.from = {id, pin.port};
    } else if (const auto link = link_at(state.document(), id, pin.port)) {
        wire.from_output = wire.taken = true;
        wire.from = *link;
        wire.type = state.model.type_of(*link).value_or(pin.type);
    }
    find_loops(state.document(), wire);
}

const Port& port_of(const Card& card, const Field& field) {
    return card.type->ports[field.index];
}

void begin_value(State& state, const Card& card, const Field& field) {
    begin(state, Kind::value);
    Gesture& value = state.gesture;
    value.node = card.id;
    value.port = field.port;
    value.port_index = field.index;
    value.lane = field.lane;
    value.width = field.width * state.view.zoom;
    const Node& node = *state.document().find(card.id);
    value.start_value = numbers_at(node, port_of(card, field))[static_cast<size_t>(field.lane)];
}

void select(State& state, const std::string& id) {
    std::set<std::string>& selected = state.view.selected;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyShift || io.KeyCtrl) {
        if (!selected.erase(id)) selected.insert(id);
    } else if (!selected.contains(id)) {
        selected = {id};
    }
    std::erase(state.view.order, id);
    state.view.order.push_back(id);
    state.layout_stale = true;
}

void toggle_more(State& state, const Card& card) {
    bool& all = card.kind == Card::Kind::surface ? state.view.all_surface : state.view.all_outputs;
    all = !all;
    state.layout_stale = true;
}

void open_popup(State& state, const Card& card, const Field* field, Popup::Kind kind) {
    Popup popup;
    popup.kind = kind;
    popup.opening = true;
    popup.node = card.id;
    const ImVec2 inset = field ? ImVec2(field->x, field->y) : ImVec2(4, 2);
    popup.at = to_screen(state.view, card.at + inset);
    popup.width = std::max((field ? field->width : card.size.x - 8) * state.view.zoom, 96.0F);
    popup.text = card.id;
    if (field) {
        popup.port_index = field->index;
        popup.lane = field->lane;
        popup.text =
            typed_value(*state.document().find(card.id), port_of(card, *field), field->lane);
    }
    if (kind == Popup::Kind::file) popup.files = image_files(state.folder());
    state.popup = std::move(popup);
}

// A press that did not become a drag.
void click_field(State& state, const Card& card, const Field& field) {
    const Port& port = port_of(card, field);
    const Document& document = state.document();
    if (port.kind == Port::Kind::choice) {
        open_popup(state, card, &field, Popup::Kind::choice);
    } else if (port.kind == Port::Kind::flag) {
        const bool on = numbers_at(*document.find(card.id), port)[0] != 0;
        state.commit(card.id + ": " + port.name, with_flag(document, card.id, port, !on));
    } else if (port.type == PortType::image_ && port.is_value()) {
        open_popup(state, card, &field, Popup::Kind::file);
    }
}

void double_click(State& state, const Hit& hit) {
    if (hit.kind == Hit::Kind::header) {
        const Card& card = state.layout.cards[hit.card];
        if (card.kind == Card::Kind::node) open_popup(state, card, nullptr, Popup::Kind::rename);
    } else if (hit.kind == Hit::Kind::field) {
        const Card& card = state.layout.cards[hit.card];
        const Field& field = card.fields[hit.part];
        if (field.lanes > 0) open_popup(state, card, &field, Popup::Kind::text);
    }
}

void press(State& state, const Hit& hit) {
    const ImGuiIO& io = ImGui::GetIO();
    state.view.selected_wire.reset();
    if (io.KeyAlt) return begin(state, Kind::pan);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) double_click(state, hit);
    if (state.popup.kind != Popup::Kind::none) return;
    switch (hit.kind) {
        case Hit::Kind::pin: {
            const Card& card = state.layout.cards[hit.card];
            return begin_wire(state, card, card.pins[hit.part]);
        }
        case Hit::Kind::field: {
            const Card& card = state.layout.cards[hit.card];
            return begin_value(state, card, card.fields[hit.part]);
        }
        case Hit::Kind::header:
        case Hit::Kind::card:
            select(state, state.layout.cards[hit.card].id);
            return begin(state, Kind::move);
        case Hit::Kind::more:
            return toggle_more(state, state.layout.cards[hit.card]);
        case Hit::Kind::wire: {
            const Wire& wire = state.layout.wires[hit.part];
            state.view.selected.clear();
            state.view.selected_wire = Link{wire.node, wire.port};
            return;
        }
        case Hit::Kind::nothing:
            if (!io.KeyShift) state.view.selected.clear();
            return begin(state, Kind::box);
    }
}

void drag_value(State& state, ImVec2 delta) {
    const Gesture& g = state.gesture;
    const NodeType* type = state.type_of(g.node);
    if (!type) return;
    const Port& port = type->ports[g.port_index];
    if (lanes_of_field(port) == 0) return;
    const ImGuiIO& io = ImGui::GetIO();
    const double value = dragged(g.start_value, delta.x, g.width, port, io.KeyCtrl, io.KeyShift);
    state.commit(g.node + ": " + port.name,
                 with_number(state.document(), g.node, port, g.lane, value), g.merge);
}

void drag_move(State& state, ImVec2 delta) {
    const ImVec2 by = delta * (1 / state.view.zoom);
    state.gesture.offset = {std::round(by.x / 8) * 8, std::round(by.y / 8) * 8};
    state.layout_stale = true;
}

void drag_box(State& state) {
    const ImVec2 a = to_canvas(state.view, state.gesture.start);
    const ImVec2 b = to_canvas(state.view, ImGui::GetIO().MousePos);
    const ImVec2 low(std::min(a.x, b.x), std::min(a.y, b.y));
    const ImVec2 high(std::max(a.x, b.x), std::max(a.y, b.y));
    if (!ImGui::GetIO().KeyShift) state.view.selected.clear();
    for (const Card& card : state.layout.cards)
        if (card.at.x < high.x && card.at.y < high.y && card.at.x + card.size.x > low.x &&
            card.at.y + card.size.y > low.y)
            state.view.selected.insert(card.id);
}

void drag(State& state) {
    Gesture& g = state.gesture;
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 delta = io.MousePos - g.start;
    if (!g.moved && std::fabs(delta.x) < threshold && std::fabs(delta.y) < threshold) return;
    if (!g.moved && g.kind == Kind::wire && g.taken) {
        state.commit("Disconnect " + g.from.text(), without_wire(state.document(), g.node, g.port),
                     g.merge);
        find_loops(state.document(), g);
    }
    g.moved = true;
    switch (g.kind) {
        case Kind::pan:
            state.view.pan = state.view.pan + io.MouseDelta;
            break;
        case Kind::box:
            drag_box(state);
            break;
        case Kind::move:
            drag_move(state, delta);
            break;
        case Kind::value:
            drag_value(state, delta);
            break;
        case Kind::wire:
        case Kind::none:
            break;
    }
}

void drop_wire(State& state) {
    const Gesture wire = state.gesture;
    const Hit hit = pick(state, ImGui::GetIO().MousePos);
    if (hit.kind == Hit::Kind::pin) {
        const Card& card = state.layout.cards[hit.card];
        connect_wire(state, wire, card, card.pins[hit.part]);
    } else if (wire.moved && !wire.taken &&
               (hit.kind == Hit::Kind::nothing || hit.kind == Hit::Kind::wire)) {
        open_palette(state, ImGui::GetIO().MousePos, wire);
    }
}

void drop_cards(State& state) {
    const ImVec2 by = state.gesture.offset;
    refresh(state);  // the cards stand where the last motion has put them
    std::vector<NodePosition> places;
    for (const Card& card : state.layout.cards) {
        if (!state.view.selected.contains(card.id)) continue;
        if (card.kind == Card::Kind::node) places.push_back({card.id, card.at.x, card.at.y});
        if (card.kind == Card::Kind::surface) state.view.surface_at = card.at;
        if (card.kind == Card::Kind::outputs) state.view.outputs_at = card.at;
    }
    if (by.x != 0 || by.y != 0) state.commit("Move", move_nodes(state.document(), places));
}

void release(State& state) {
    const Gesture g = state.gesture;
    switch (g.kind) {
        case Kind::wire:
            drop_wire(state);
            break;
        case Kind::move:
            if (g.moved) drop_cards(state);
            break;
        case Kind::value:
            if (!g.moved) {
                // Copies: what a click does may lay the cards out anew. No card: the node is gone.
                const Card* found = state.layout.find(g.node);
                const Card card = found ? *found : Card();
                for (const Field& field : card.fields)
                    if (field.port == g.port && field.lane == g.lane)
                        click_field(state, card, field);
            }
            break;
        default:
            break;
    }
    state.gesture = {};
    state.layout_stale = true;
}

void cancel(State& state) {
    if (state.gesture.moved) state.history.cancel(state.gesture.merge);
    state.gesture = {};
    state.layout_stale = true;
}

void zoom_by_wheel(State& state) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheel != 0) zoom_at(state.view, io.MousePos, std::pow(1.1F, io.MouseWheel));
}

}  // namespace

bool wire_fits(const State& state, const Gesture& wire, const Card& card, const Pin& pin) {
    return why_not(state, wire, card, pin).empty();
}

void connect_wire(State& state, const Gesture& wire, const Card& card, const Pin& pin) {
    const std::string id = card.kind == Card::Kind::outputs ? "" : card.id;
    if (wire.taken && id == wire.node && pin.port == wire.port && !pin.output) {
        if (wire.moved) state.history.cancel(wire.merge);
        return;
    }
    if (!wire.moved) return;
    if (const std::string why = why_not(state, wire, card, pin); !why.empty()) {
        if (wire.taken) state.history.cancel(wire.merge);
        state.status = why;
        return;
    }
    const Link from = wire.from_output ? wire.from : Link{card.id, pin.port};
    const std::string to = wire.from_output ? id : wire.node;
    const std::string port = wire.from_output ? pin.port : wire.port;
    state.commit("Connect " + from.text() + " to " + (to.empty() ? "output" : to) + "." + port,
                 with_wire(state.document(), from, to, port), wire.merge);
}

void update_gesture(State& state, bool hovered) {
    const ImGuiIO& io = ImGui::GetIO();
    state.hovered = hovered || state.gesture.kind != Kind::none ? pick(state, io.MousePos) : Hit{};
    if (state.gesture.kind == Kind::none && hovered) {
        zoom_by_wheel(state);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) press(state, state.hovered);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) begin(state, Kind::pan);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Right) &&
            state.hovered.kind == Hit::Kind::nothing)
            open_palette(state, io.MousePos, {});
    } else if (state.gesture.kind != Kind::none) {
        drag(state);
        const int button = io.MouseDown[2] || io.MouseReleased[2] ? 2 : 0;
        if (ImGui::IsKeyPressed(io.KeyMap[ImGuiKey_Escape], false))
            cancel(state);
        else if (!io.MouseDown[button])
            release(state);
    }
}

void draw_canvas(State& state) {
    View& view = state.view;
    view.corner = ImGui::GetCursorScreenPos();
    view.extent = ImGui::GetContentRegionAvail();
    if (!view.fitted && view.extent.x > 0) {
        fit(view, state.layout, false);
        view.fitted = true;
    }
    ImGui::InvisibleButton("canvas", view.extent,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                               ImGuiButtonFlags_MouseButtonRight);
    update_gesture(state, ImGui::IsItemHovered());
    refresh(state);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(view.corner, view.corner + view.extent, true);
    draw_graph(state, list);
    list.PopClipRect();
    name_targets(state);
}

}  // namespace wrinkle::editor

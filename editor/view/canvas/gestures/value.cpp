#include "editor/view/canvas/gestures/gestures.h"

#include <algorithm>

#include "base/text.h"
#include "editor/model/document/field.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

const Port& port_of(const Card& card, const Field& field) {
    return card.type->ports[field.index];
}

// Handles a press that did not become a drag.
void click_field(State& state, const Card& card, const Field& field) {
    const Port& port = port_of(card, field);
    const Document& document = state.document();
    if (port.kind == Port::Kind::flag) {
        const bool on = numbers_at(*document.find(card.id), port)[0] != 0;
        state.commit(card.id + ": " + port.name, with_flag(document, card.id, port, !on));
    } else if (field.shows != Field::Shows::value || port.kind == Port::Kind::choice ||
               (port.is_value() &&
                (port.type == PortType::image_ || port.type == PortType::color_))) {
        open_field(state, card, field);
    }
}

}  // namespace

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
        const auto numbers = numbers_at(*state.document().find(card.id), port_of(card, *field));
        popup.text = shortest(numbers[static_cast<size_t>(field->lane)]);  // with all digits
    }
    if (kind == Popup::Kind::file) popup.files = image_files(state.folder());
    state.popup = std::move(popup);
}

void begin_value(State& state, const Card& card, const Field& field) {
    begin_gesture(state, Gesture::Kind::value);
    Gesture& value = state.gesture;
    value.node = card.id;
    value.port = field.port;
    value.port_index = field.index;
    value.lane = field.lane;
    value.drags = field.shows == Field::Shows::value;
    value.width = field.width * state.view.zoom;
    const Node& node = *state.document().find(card.id);
    value.start_values = numbers_at(node, port_of(card, field));
}

void drag_value(State& state, ImVec2 delta) {
    const Gesture& g = state.gesture;
    const NodeType* type = state.type_of(g.node);
    if (!type) return;
    const Port& port = type->ports[g.port_index];
    if (lanes_of_field(port) == 0 || !g.drags) return;
    const ImGuiIO& io = ImGui::GetIO();
    const bool all = io.KeyCtrl && io.KeyShift;
    const double start = g.start_values[static_cast<size_t>(g.lane)];
    const double value =
        dragged(start, delta.x, g.width, port, io.KeyCtrl && !all, io.KeyShift && !all);
    Document document = state.document();
    for (int lane = 0; lane < lanes_of_field(port); ++lane) {
        const double other = g.start_values[static_cast<size_t>(lane)];
        const double scaled = other == start ? value
                              : start != 0   ? other * (value / start)
                                             : other + value;
        if (lane == g.lane || all) document = with_number(document, g.node, port, lane, scaled);
    }
    state.commit(g.node + ": " + port.name, document, g.merge);
}

void drop_value(State& state) {
    const Gesture g = state.gesture;
    if (g.moved) return;
    // Copies, because a click may rebuild the layout. If the node is gone, an empty card.
    const Card* found = state.layout.find(g.node);
    const Card card = found ? *found : Card();
    for (const Field& field : card.fields)
        if (field.port == g.port && field.lane == g.lane) click_field(state, card, field);
}

}  // namespace wrinkle::editor


#include <algorithm>

#include "editor/model/document/wiring.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/new_cards.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

constexpr int far_off = 20;

// Lower is better: same types, the main input, few other inputs.
int distance(const NodeType& type, const Passage& through, PortType from, PortType to) {
    int away = 0, inputs = 0;
    for (const Port& port : type.ports) {
        const bool is_output = port.kind == Port::Kind::output;
        if (port.is_value()) {
            if (port.name == through.in) away += 100 * (port.type != from) + 20 * (inputs > 0);
            ++inputs;
        }
        if (is_output && port.name == through.out) away += 100 * (port.type != to);
    }
    return away + inputs;
}

}  // namespace

std::vector<Offer::Choice> between(const Registry& registry, PortType from, PortType to,
                                   size_t most) {
    std::vector<std::pair<int, Offer::Choice>> found;
    for (const NodeType& type : registry.list()) {
        if (type.family == "comparison") continue;
        if (const auto through = passage(type, from, to))
            found.emplace_back(distance(type, *through, from, to),
                               Offer::Choice{&type, through->in, through->out});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Offer::Choice> choices;
    for (size_t i = 0; i < std::min(most, found.size()); ++i)
        if (found[i].first < found[0].first + far_off) choices.push_back(found[i].second);
    return choices;
}

void offer_between(State& state, const Gesture& wire, const Card& card, const Pin& pin) {
    if (pin.output == wire.from_output || !pin.known) return;
    Offer offer;
    offer.connection = connection_at(wire, card, pin);
    const auto given = state.model.type_of(offer.connection.from);
    const auto wanted = wanted_at(state.model, offer.connection.node, offer.connection.port);
    if (!given || !wanted || converts(*given, wanted) || wire.loops.contains(card.link_id()))
        return;
    if (wire.taken) offer.lifted = Link{wire.node, wire.port};
    offer.choices = between(*state.registry, *given, *wanted);
    offer.why = state.status;
    if (!offer.choices.empty()) offer.why = offer.why.substr(0, offer.why.find(';')) + ".";
    offer.at = ImGui::GetIO().MousePos;
    offer.open = offer.opening = true;
    state.offer = std::move(offer);
}

void accept_offer(State& state, size_t choice) {
    const Offer offer = std::move(state.offer);
    state.offer = {};
    if (choice >= offer.choices.size()) return;
    const Offer::Choice& chosen = offer.choices[choice];
    Node node = node_of_type(state.document(), *chosen.type);
    const std::string id = node.id;
    const ImVec2 wanted = to_canvas(state.view, offer.at) - ImVec2(224, 40);
    const ImVec2 at = free_place(state, wanted, node, chosen.type);
    Document document = state.document();
    if (offer.lifted)
        document = cut_wires(state.model, document,
                             {{offer.connection.from, offer.lifted->node, offer.lifted->port}});
    document = add_node(document, std::move(node), at.x, at.y);
    state.commit(
        "Insert " + chosen.type->title,
        insert_in_wire(settled(state, document), offer.connection, id, {chosen.in, chosen.out}));
    show_new(state, {id});
}

}  // namespace wrinkle::editor

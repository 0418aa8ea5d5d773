// Tests that a layout updated after an edit, which reuses cards, equals one built from scratch.
#include <tuple>

#include "editor/view/canvas/layout.h"
#include "editor/view/refresh.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "headless.h"
#include "random_graph.h"

namespace wrinkle::editor {
namespace {

using Random = std::mt19937;

std::string told(const ImVec2& at) {
    return std::to_string(at.x) + "," + std::to_string(at.y);
}

// Lists all elements of a layout that are drawn or hit-tested, one per line.
std::string told(const Layout& layout) {
    std::string text;
    const auto line = [&](const auto&... words) {
        ((text += words, text += ' '), ...);
        text += '\n';
    };
    for (const Card& card : layout.cards) {
        line("card", card.id, card.label, told(card.at), told(card.size),
             card.type ? card.type->title : "", std::to_string(static_cast<int>(card.kind)),
             card.muted ? "muted" : "", card.reroute ? "reroute" : "", std::to_string(card.more_y),
             card.name, card.title, std::to_string(card.name_width));
        for (const Pin& pin : card.pins)
            line("pin", pin.port, name_of(pin.type), std::to_string(pin.y), pin.label,
                 pin.known ? "" : "unknown", pin.output ? "out" : "in",
                 pin.connected ? "connected" : "", pin.in_field ? "in field" : "");
        for (const Field& field : card.fields)
            line("field", field.port, std::to_string(field.lane), std::to_string(field.x),
                 std::to_string(field.y), std::to_string(field.width), field.name, field.value,
                 std::to_string(field.part));
    }
    for (const Wire& wire : layout.wires)
        line("wire", wire.from.text(), wire.node, wire.port, told(wire.start), told(wire.end),
             name_of(wire.from_type), name_of(wire.to_type), wire.known ? "" : "unknown",
             std::to_string(static_cast<int>(wire.conversion)), layout.cards[wire.from_card].id,
             layout.cards[wire.to_card].id);
    for (const auto& boxes : {layout.card_boxes, layout.wire_boxes})
        for (const Extent& box : boxes)
            line("box", told(box.low), told(box.high));
    for (size_t i = 0; i < layout.nodes.size(); ++i)
        line("node", layout.cards[layout.card_of_node[i]].id, std::to_string(layout.readers[i]));
    line("all", told(layout.bounds.low), told(layout.bounds.high));
    return text;
}

class RandomEdits {
public:
    explicit RandomEdits(Random& random) : random_(random) {}

    Document any(const Document& document) {
        const std::string id = node(document), other = node(document);
        switch (random_() % 14) {
            case 0:
            case 1:
                return set_value(document, id, port(document, id), number());
            case 2:
                return move_node(document, id, part(), part());
            case 3:
                return move_nodes(document, {{id, part(), part()}, {other, part(), 3}});
            case 4:
                return remove_node(document, id);
            case 5:
                return remove_nodes(document, {id, other});
            case 6:
            case 7:
                return connect(document, {other, port_out(document, other)}, id,
                               port(document, id));
            case 8:
                return reset_value(document, id, port(document, id));
            case 9:
                return rename_node(document, id, free_id(document, "renamed"));
            case 10:
                return mute_nodes(document, {id}, random_() % 2);
            case 11:
                return set_output(document, random_() % 2 ? "normal" : "mine",
                                  {other, port_out(document, other)});
            case 12:
                return connect(document, {"surface", "uv0"}, id, port(document, id));
            default:
                return added(document, id);
        }
    }

private:
    float part() { return static_cast<float>(random_() % 2000); }
    json::Value number() { return json::Value::number(random_() % 9 * 0.5); }
    std::string node(const Document& document) {
        return document.nodes.empty() ? "" : document.nodes[random_() % document.nodes.size()]->id;
    }
    std::string port_of(const Document& document, const std::string& id, bool output) {
        const Node* node = document.find(id);
        const NodeType* type = node ? built_in_registry().find(node->type) : nullptr;
        std::vector<std::string> names;
        for (const Port& port : type ? type->ports : std::vector<Port>())
            if ((port.kind == Port::Kind::output) == output) names.push_back(port.name);
        if (names.empty() || random_() % 40 == 0) return output ? "out" : "in";
        return names[random_() % names.size()];
    }
    std::string port(const Document& d, const std::string& id) { return port_of(d, id, false); }
    std::string port_out(const Document& d, const std::string& id) { return port_of(d, id, true); }

    Document added(const Document& document, const std::string& id) {
        const auto& types = built_in_registry().list();
        Node node;
        node.type = random_() % 3 == 0    ? "reroute"
                    : random_() % 20 == 0 ? "missing"
                                          : types[random_() % types.size()].id;
        node.id = free_id(document, "added");
        const std::string made = node.id;
        if (random_() % 12 == 0) return add_node(document, std::move(node));
        const Document with = add_node(document, std::move(node), part(), part());
        return connect(with, {id, port_out(document, id)}, made, port(with, made));
    }

    Random& random_;
};

class UpdatedLayout : public Headless {
protected:
    void step(Random& random, RandomEdits& edits) {
        const size_t what = random() % 10;
        if (what < 2)
            state.history.undo();
        else if (what < 4)
            state.history.redo();
        else if (what == 4)
            raise(random);
        else
            state.commit("edit", edits.any(state.document()));
        state.model = make_model(state.document(), state.folder(), built_in_registry());
        update_layout(state);
    }
    void raise(Random& random) {
        if (state.document().nodes.empty()) return;
        const std::string id = state.document().nodes[random() % state.document().nodes.size()]->id;
        std::erase(state.view.order, id);
        state.view.order.push_back(id);
        state.layout_stale = true;
    }
};

TEST_F(UpdatedLayout, IsTheOneMadeFromNothing) {
    open(small_graph);
    Random random(7);
    RandomEdits edits(random);
    for (int graph = 0; graph < 40; ++graph) {
        Document start = random_graph(random);
        for (size_t i = 0; graph % 4 && i < start.nodes.size(); ++i)
            start = move_node(start, start.nodes[i]->id, static_cast<double>(i) * 90, 40);
        state.history = History(start);
        state.view.order.clear();
        state.layout_stale = true;
        for (int i = 0; i < 60; ++i) {
            const std::string before = write_document(state.document());
            step(random, edits);
            const Layout kept = state.layout;
            state.layout = {};
            update_layout(state);
            ASSERT_EQ(told(kept), told(state.layout))
                << before << "\n-> " << write_document(state.document());
            state.layout = kept;
        }
    }
}

}  // namespace
}  // namespace wrinkle::editor

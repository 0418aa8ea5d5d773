#include "random_graph.h"

#include "graph/edit.h"
#include "graph/order.h"
#include "headless.h"
#include "lower/conversion.h"

namespace wrinkle::editor {
namespace {

// Links inputs to random earlier nodes with a type that converts; the graph is therefore acyclic.
Document wired(Document document, std::mt19937& random) {
    const Model model = make_model(document, ".", built_in_registry());
    for (size_t i = 1; i < document.nodes.size(); ++i) {
        const std::string id = document.nodes[i]->id;
        const NodeType* type = model.type_of(id);
        if (!type) continue;
        for (const Port& port : type->ports) {
            if (!port.is_value() || random() % 4 == 0) continue;
            for (int tries = 0; tries < 8; ++tries) {
                const NodePtr& source = document.nodes[random() % i];
                const NodeType* giver = model.type_of(source->id);
                const Port& out = giver->ports[random() % giver->ports.size()];
                if (out.kind != Port::Kind::output || source->type == reroute_type) continue;
                if (conversion(out.type, port.type) == Conversion::illegal) continue;
                document = connect(document, {source->id, out.name}, id, port.name);
                break;
            }
        }
    }
    return document;
}

// Adds reroutes to random wires, including the wires of earlier reroutes.
Document rerouted(Document document, std::mt19937& random) {
    for (size_t i = 0; i < document.nodes.size(); ++i) {
        const NodePtr node = document.nodes[i];
        for (const Input& input : node->inputs) {
            if (input.kind != Input::Kind::link || random() % 5 != 0) continue;
            Node reroute;
            reroute.type = reroute_type;
            reroute.id = free_id(document, "bend");
            const std::string id = reroute.id;
            document = add_node(document, std::move(reroute));
            document = connect(document, input.link, id, "in");
            document = connect(document, {id, "out"}, node->id, input.port);
        }
    }
    return document;
}

}  // namespace

Document random_graph(std::mt19937& random) {
    const auto& types = built_in_registry().list();
    Document document;
    const size_t count = 4 + random() % 12;
    for (size_t i = 0; i < count; ++i) {
        Node node;
        node.type = types[random() % types.size()].id;
        node.id = free_id(document, node.type);
        document = add_node(document, std::move(node));
    }
    document = rerouted(wired(std::move(document), random), random);
    std::vector<NodePosition> places;
    for (size_t i = 0; i < document.nodes.size(); ++i)
        places.push_back({document.nodes[i]->id, static_cast<double>(i % 6) * 280,
                          static_cast<double>(i / 6) * 360});
    document = move_nodes(document, places);
    const Model model = make_model(document, ".", built_in_registry());
    for (const std::string_view name : standard_outputs())
        for (const NodePtr& node : document.nodes) {
            const NodeType* type = model.type_of(node->id);
            for (const Port& port : type->ports)
                if (port.kind == Port::Kind::output && random() % 4 == 0 &&
                    conversion(port.type, *standard_output(name)) != Conversion::illegal)
                    document = set_output(document, name, {node->id, port.name});
        }
    return document;
}

size_t bad_wires(const Document& document) {
    const Model model = make_model(document, ".", built_in_registry());
    size_t bad = 0;
    for (const NodePtr& node : document.nodes) {
        const NodeType* type = model.type_of(node->id);
        for (const Input& input : node->inputs) {
            if (input.kind != Input::Kind::link) continue;
            const auto given = model.type_of(input.link);
            const uint32_t port = type ? type->find_input(input.port) : NodeType::none;
            bad += !given || port == NodeType::none ||
                   conversion(*given, type->ports[port].type) == Conversion::illegal;
        }
    }
    for (const Output& output : document.outputs) {
        const auto given = model.type_of(output.from.link);
        const auto wanted = standard_output(output.name);
        bad += !given || (wanted && conversion(*given, *wanted) == Conversion::illegal);
    }
    return bad;
}

size_t bad_links(const Document& document) {
    Diagnostics problems;
    check_links(document, problems);
    return problems.error_count();
}

}  // namespace wrinkle::editor

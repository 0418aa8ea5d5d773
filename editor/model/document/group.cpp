#include "editor/model/document/group.h"

#include "editor/model/document/wiring.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

class Grouper {
public:
    Grouper(const Model& model, const Document& document, const std::set<std::string>& ids)
        : model_(model), document_(document), ids_(ids) {}

    bool run(const std::string& file, std::string& why) {
        why.clear();
        take_nodes();
        each_wire(document_, [&](const Connection& wire) {
            if (why.empty()) note(wire, why);
        });
        return why.empty() && put_node(file, why);
    }

    Group group;

private:
    void take_nodes() {
        std::vector<Node> nodes;
        for (const NodePtr& node : document_.nodes)
            if (ids_.contains(node->id)) nodes.push_back(*node);
        std::vector<NodePosition> places;
        for (const Position& at : document_.positions)
            if (ids_.contains(at.id)) places.push_back({at.id, at.x, at.y});
        group.inner = add_nodes({}, std::move(nodes), places);
        group.inner = set_back_faces(group.inner, document_.back_faces);
    }

    // Handles a wire of the document: connects it if it crosses the border of the group.
    void note(const Connection& wire, std::string& why) {
        const bool from = ids_.contains(wire.from.node), to = ids_.contains(wire.node);
        if (from == to || wire.from.is_surface()) return;
        const auto type = model_.type_of(wire.from);
        if (!type) {
            why = "The type of " + wire.from.text() + " is not known.";
        } else if (to) {
            group.inner = connect(group.inner, {std::string(Link::input), input_for(wire, *type)},
                                  wire.node, wire.port);
        } else {
            leaving_.push_back({{"", output_for(wire, *type)}, wire.node, wire.port});
        }
    }

    std::string input_for(const Connection& wire, PortType type) {
        for (const auto& [source, name] : sources_)
            if (source == wire.from) return name;
        std::string name = wire.port;
        for (size_t n = 2; group.inner.inputs.find(name); ++n)
            name = wire.port + std::to_string(n);
        GraphInput input;
        input.name = name;
        input.type = name_of(type);
        group.inner = set_graph_input(group.inner, std::move(input));
        sources_.emplace_back(wire.from, name);
        return name;
    }

    // A standard output name requires its standard type.
    std::string output_for(const Connection& wire, PortType type) {
        for (const Output& output : group.inner.outputs)
            if (output.from.link == wire.from) return output.name;
        std::string name = wire.from.port;
        const auto taken = [&] {
            const auto standard = standard_output(name);
            return group.inner.outputs.find(name) || (standard && *standard != type);
        };
        for (size_t n = 2; taken(); ++n)
            name = wire.from.port + std::to_string(n);
        group.inner = set_output(group.inner, name, wire.from);
        return name;
    }

    bool put_node(const std::string& file, std::string& why) {
        Node node = new_node(document_, fs::path(file).stem().string(), type_of_subgraph(file));
        group.node = node.id;
        group.outer = add_node(document_, std::move(node));
        for (const auto& [source, name] : sources_)
            group.outer = connect(group.outer, source, group.node, name);
        for (const Connection& wire : leaving_)
            group.outer =
                with_wire(group.outer, {group.node, wire.from.port}, wire.node, wire.port);
        group.outer = remove_nodes(group.outer, ids_);
        for (const auto& [source, name] : sources_)
            if (source.is_node() && would_cycle(group.outer, source, group.node)) {
                why = "A wire leaves the selected nodes and comes back to them through " +
                      source.node + ". Select that one too.";
                return false;
            }
        return true;
    }

    const Model& model_;
    const Document& document_;
    const std::set<std::string>& ids_;
    std::vector<std::pair<Link, std::string>> sources_;
    std::vector<Connection> leaving_;  // wire.from.port is the group's output
};

}  // namespace

std::optional<Group> make_group(const Model& model, const Document& document,
                                const std::set<std::string>& ids, const std::string& file,
                                std::string& why) {
    Grouper grouper(model, document, ids);
    if (!grouper.run(file, why)) return std::nullopt;
    if (grouper.group.inner.nodes.empty()) {
        why = "No node is selected.";
        return std::nullopt;
    }
    return std::move(grouper.group);
}

}  // namespace wrinkle::editor

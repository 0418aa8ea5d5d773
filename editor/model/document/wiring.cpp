#include "editor/model/document/wiring.h"

#include <algorithm>

#include "editor/model/document/field.h"
#include "editor/model/words.h"
#include "graph/edit.h"
#include "lower/conversion.h"

namespace wrinkle::editor {
namespace {

bool is_link(const Input* input) {
    return input && input->kind == Input::Kind::link;
}

bool is_reroute(const Document& document, const std::string& node) {
    const Node* found = node.empty() ? nullptr : document.find(node);
    return found && found->type == reroute_type;
}

// Returns the source that replaces an output of the node when the node is removed.
std::optional<Link> passed_on(const Model& model, const Node& node, const std::string& output) {
    const NodeType* type = model.type_of(node.id);
    const Port* out = output_port(type, output);
    if (!out) return std::nullopt;
    const Input* convertible = nullptr;
    for (const Port& port : type->ports) {
        if (!port.is_value()) continue;
        const Input* input = node.find(port.name);
        if (port.type == out->type && is_link(input)) return input->link;
        if (!convertible && is_link(input) && converts(port.type, out->type)) convertible = input;
    }
    return convertible ? std::optional(convertible->link) : std::nullopt;
}

// Returns the first source upstream of `link` that is not removed.
std::optional<Link> staying(const Model& model, const Document& document,
                            const std::set<std::string>& removed, Link link) {
    for (size_t step = 0; step <= removed.size(); ++step) {
        if (!link.is_node() || !removed.contains(link.node)) return link;
        const Node* node = document.find(link.node);
        const auto before = node ? passed_on(model, *node, link.port) : std::nullopt;
        if (!before) return std::nullopt;
        link = *before;
    }
    return std::nullopt;
}

// Returns the reroutes that lost their source, and those downstream: they carry a float.
std::set<std::string> loose_reroutes(const Document& before, const Document& after) {
    std::set<std::string> loose;
    for (bool more = true; more;) {
        more = false;
        for (const NodePtr& node : after.nodes) {
            if (node->type != reroute_type || loose.contains(node->id)) continue;
            const Node* old = before.find(node->id);
            const Input* in = node->find("in");
            const bool lost = !is_link(in) && old && is_link(old->find("in"));
            if (!lost && !(is_link(in) && loose.contains(in->link.node))) continue;
            more = loose.insert(node->id).second;
        }
    }
    return loose;
}

// Removes wires that no longer fit: a reroute has the type of its source, a float without one.
Document without_invalid_links(const Model& model, const Document& before, const Document& after) {
    const std::set<std::string> loose = loose_reroutes(before, after);
    if (loose.empty()) return after;
    Document result = after;
    each_wire(after, [&](const Connection& wire) {
        if (loose.contains(wire.from.node) && !is_reroute(after, wire.node) &&
            !converts(PortType::float_, wanted_at(model, wire.node, wire.port)))
            result = without_wire(result, wire.node, wire.port);
    });
    return result;
}

bool takes_wire(const Model& model, const Document& document, const std::string& node,
                const std::string& port) {
    if (node.empty() || is_reroute(document, node)) return true;
    const Port* input = input_port(model.type_of(node), port);
    return input && input->is_value();
}

// Returns the inputs that get the value of a wire to this one: itself, or those fed by a reroute,
// also through other reroutes.
std::vector<Connection> ends_at(const Document& document, const std::string& node,
                                const std::string& port) {
    if (!is_reroute(document, node)) return {{{}, node, port}};
    std::set<std::string> chain = {node};
    std::vector<Connection> ends;
    for (size_t known = 0; known != chain.size();) {
        known = chain.size();
        ends.clear();
        each_wire(document, [&](const Connection& wire) {
            if (!chain.contains(wire.from.node)) return;
            if (is_reroute(document, wire.node))
                chain.insert(wire.node);
            else
                ends.push_back(wire);
        });
    }
    return ends;
}

// Returns the first of these inputs that a value of that type does not fit.
std::optional<Connection> misfit(const Model& model, const Document& document, PortType given,
                                 const std::string& node, const std::string& port) {
    for (const Connection& end : ends_at(document, node, port))
        if (!converts(given, wanted_at(model, end.node, end.port))) return end;
    return std::nullopt;
}

// Returns the first two inputs of the same type, preferring those with a value or a wire. Inputs
// that read the surface by default are left out: not every such default can be written as a wire at
// another input.
std::vector<const Port*> twins(const NodeType& type, const Node& node) {
    const auto counts = [](const Port& port) {
        return port.is_value() && port.default_kind != Port::Default::surface;
    };
    for (const Port& first : type.ports) {
        if (!counts(first)) continue;
        std::vector<const Port*> same;
        for (const Port& port : type.ports)
            if (counts(port) && port.type == first.type) same.push_back(&port);
        if (same.size() < 2) continue;
        std::stable_partition(same.begin(), same.end(),
                              [&](const Port* port) { return node.find(port->name); });
        same.resize(2);
        return same;
    }
    return {};
}

bool same_default(const Port& a, const Port& b) {
    return a.default_kind == b.default_kind && a.default_value == b.default_value;
}

// Moves the input at port `from` of the old node, or its default, to port `to`.
Document hand_on(const Document& document, const Node& old, const Port& from, const Port& to) {
    const Input* input = old.find(from.name);
    const Document bare = reset_value(document, old.id, to.name);
    if (input && input->kind == Input::Kind::link)
        return connect(bare, input->link, old.id, to.name);
    if (input) return set_value(bare, old.id, to.name, input->value);
    if (same_default(from, to)) return bare;
    const int lanes = lanes_of_field(from);
    return lanes > 0 ? set_value(bare, old.id, to.name, literal_of(from.default_value, lanes))
                     : bare;
}

}  // namespace

Node new_node(const Document& document, std::string_view id, std::string_view type) {
    Node node;
    node.id = free_id(document, id);
    node.type = type;
    return node;
}

std::optional<Link> link_at(const Document& document, const std::string& node,
                            const std::string& port) {
    const Input* input = nullptr;
    if (node.empty()) {
        const Output* output = document.outputs.find(port);
        input = output ? &output->from : nullptr;
    } else if (const Node* reader = document.find(node)) {
        input = reader->find(port);
    }
    if (!input || input->kind != Input::Kind::link) return std::nullopt;
    return input->link;
}

Document with_wire(const Document& document, const Link& from, const std::string& node,
                   const std::string& port) {
    return node.empty() ? set_output(document, port, from) : connect(document, from, node, port);
}

Document without_wire(const Document& document, const std::string& node, const std::string& port) {
    return node.empty() ? remove_output(document, port) : disconnect(document, node, port);
}

bool converts(PortType from, std::optional<PortType> to) {
    return !to || conversion(from, *to) != Conversion::illegal;
}

std::optional<PortType> wanted_at(const Model& model, const std::string& node,
                                  const std::string& port) {
    if (node.empty()) return standard_output(port);
    const Port* input = input_port(model.type_of(node), port);
    return input ? std::optional(input->type) : std::nullopt;
}

bool wire_is_legal(const Model& model, const Document& document, PortType given,
                   const std::string& node, const std::string& port) {
    return takes_wire(model, document, node, port) && !misfit(model, document, given, node, port);
}

std::string wire_problem(const Model& model, const Document& document, const Link& from,
                         const std::string& node, const std::string& port) {
    const auto given = model.type_of(from);
    if (!given && node.empty()) return "the type of " + from.text() + " is not known";
    if (!given || (!node.empty() && !model.type_of(node)))
        return "the type of one end is not known";
    if (!takes_wire(model, document, node, port)) return node + "." + port + " takes no wire";
    const auto end = misfit(model, document, *given, node, port);
    if (!end) return {};
    const PortType wanted = *wanted_at(model, end->node, end->port);
    return from.text() + " cannot feed " + (end->node.empty() ? "" : end->node + ".") + end->port +
           ": a " + std::string(name_of(*given)) + " is not a " + std::string(name_of(wanted)) +
           ". " + sentence(alternative(*given, wanted, *model.registry));
}

std::vector<PortType> wanted_ends(const Model& model, const Document& document,
                                  const std::string& node, const std::string& port) {
    std::vector<PortType> types;
    for (const Connection& end : ends_at(document, node, port))
        if (const auto wanted = wanted_at(model, end.node, end.port)) types.push_back(*wanted);
    return types;
}

bool converts(PortType from, const std::vector<PortType>& ends) {
    return std::ranges::all_of(ends, [&](PortType to) { return converts(from, to); });
}

std::optional<Passage> passage(const NodeType& type, PortType given,
                               const std::vector<PortType>& ends) {
    const PortType wanted = ends.empty() ? given : ends.front();
    std::optional<Passage> best;
    int most = -1;
    for (const Port& in : type.ports) {
        if (!in.is_value() || !converts(given, in.type)) continue;
        if (in.type == PortType::normal_ && given != PortType::normal_) continue;
        for (const Port& out : type.ports) {
            if (out.kind != Port::Kind::output || !converts(out.type, ends)) continue;
            const int score = 2 * (in.type == given) + (out.type == wanted);
            if (score <= most) continue;
            most = score;
            best = Passage{in.name, out.name};
        }
    }
    return best;
}

Document delete_and_reconnect(const Model& model, const Document& document,
                              const std::set<std::string>& ids) {
    Document result = document;
    each_wire(document, [&](const Connection& wire) {
        if (!ids.contains(wire.from.node) || ids.contains(wire.node)) return;
        const auto from = staying(model, document, ids, wire.from);
        const auto given = from ? model.type_of(*from) : std::nullopt;
        if (given && wire_is_legal(model, document, *given, wire.node, wire.port))
            result = with_wire(result, *from, wire.node, wire.port);
    });
    return without_invalid_links(model, document, remove_nodes(result, ids));
}

Document delete_and_disconnect(const Model& model, const Document& document,
                               const std::set<std::string>& ids) {
    return without_invalid_links(model, document, remove_nodes(document, ids));
}

Document cut_wires(const Model& model, const Document& document,
                   const std::vector<Connection>& wires) {
    Document result = document;
    for (const Connection& wire : wires)
        result = without_wire(result, wire.node, wire.port);
    return without_invalid_links(model, document, std::move(result));
}

Document without_outer_wires(const Model& model, const Document& document,
                             const std::set<std::string>& ids) {
    std::vector<Connection> outer;
    each_wire(document, [&](const Connection& wire) {
        if (ids.contains(wire.node) && wire.from.is_node() && !ids.contains(wire.from.node))
            outer.push_back(wire);
    });
    return cut_wires(model, document, outer);
}

Document insert_in_wire(const Document& document, const Connection& wire, const std::string& id,
                        const Passage& through) {
    const Document fed = connect(document, wire.from, id, through.in);
    return with_wire(fed, {id, through.out}, wire.node, wire.port);
}

bool is_unconnected(const Document& document, const std::string& id) {
    bool touched = false;
    each_wire(document,
              [&](const Connection& wire) { touched |= wire.from.node == id || wire.node == id; });
    return !touched;
}

Document without_invalid_links(const Document& document, const std::set<std::string>& ids,
                               const std::filesystem::path& folder, const Registry& registry) {
    const Model model = make_model(document, folder, registry);
    Document result = document;
    each_wire(document, [&](const Connection& wire) {
        if (!ids.contains(wire.node) && !ids.contains(wire.from.node)) return;
        const auto given = model.type_of(wire.from);
        if (given && !converts(*given, wanted_at(model, wire.node, wire.port)))
            result = without_wire(result, wire.node, wire.port);
    });
    return result;
}

Document swap_inputs(const Model& model, const Document& document, const std::string& id) {
    const Node* node = document.find(id);
    const NodeType* type = model.type_of(id);
    if (!node || !type) return document;
    const std::vector<const Port*> ports = twins(*type, *node);
    Document result = document;
    for (size_t i = 0; i < ports.size(); ++i)
        result = hand_on(result, *node, *ports[i], *ports[(i + 1) % ports.size()]);
    return ports.empty() ? document : result;
}

}  // namespace wrinkle::editor

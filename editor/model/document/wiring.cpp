#include "editor/model/document/wiring.h"

#include <algorithm>

#include "graph/edit.h"
#include "lower/conversion.h"

namespace wrinkle::editor {
namespace {

bool is_link(const Input* input) {
    return input && input->kind == Input::Kind::link;
}

// Returns the source that replaces an output of the node when the node is removed.
std::optional<Link> passed_on(const Model& model, const Node& node, const std::string& output) {
    const NodeType* type = model.type_of(node.id);
    const uint32_t out = type ? type->find_output(output) : NodeType::none;
    if (out == NodeType::none) return std::nullopt;
    const PortType made = type->ports[out].type;
    const Input* convertible = nullptr;
    for (const Port& port : type->ports) {
        if (!port.is_value()) continue;
        const Input* input = node.find(port.name);
        if (port.type == made && is_link(input)) return input->link;
        if (!convertible && is_link(input) && converts(port.type, made)) convertible = input;
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
Document without_invalid_links(const Model& model, const Document& before, Document after) {
    const std::set<std::string> loose = loose_reroutes(before, after);
    if (loose.empty()) return after;
    std::vector<Connection> misfits;
    each_wire(after, [&](const Connection& wire) {
        const Node* reader = wire.node.empty() ? nullptr : after.find(wire.node);
        const bool passes_on = reader && reader->type == reroute_type;
        if (loose.contains(wire.from.node) && !passes_on &&
            !converts(PortType::float_, wanted_at(model, wire.node, wire.port)))
            misfits.push_back(wire);
    });
    for (const Connection& wire : misfits)
        after = without_wire(after, wire.node, wire.port);
    return after;
}

std::set<std::string> walk(const Document& document, std::set<std::string> ids, bool up) {
    std::vector<Connection> wires;
    each_wire(document, [&](const Connection& wire) {
        if (wire.from.is_node() && !wire.node.empty()) wires.push_back(wire);
    });
    const auto start = [&](const Connection& wire) { return up ? wire.node : wire.from.node; };
    std::sort(wires.begin(), wires.end(),
              [&](const auto& a, const auto& b) { return start(a) < start(b); });
    std::vector<std::string> open(ids.begin(), ids.end());
    while (!open.empty()) {
        const std::string id = std::move(open.back());
        open.pop_back();
        auto wire = std::lower_bound(
            wires.begin(), wires.end(), id,
            [&](const auto& each, const auto& wanted) { return start(each) < wanted; });
        for (; wire != wires.end() && start(*wire) == id; ++wire) {
            const std::string& next = up ? wire->from.node : wire->node;
            if (document.find(next) && ids.insert(next).second) open.push_back(next);
        }
    }
    return ids;
}

}  // namespace

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
    if (node.empty()) return Model::wanted_by_output(port);
    const NodeType* type = model.type_of(node);
    const uint32_t index = type ? type->find_input(port) : NodeType::none;
    if (index == NodeType::none) return std::nullopt;
    return type->ports[index].type;
}

bool wire_is_legal(const Model& model, const Document& document, PortType given,
                   const std::string& node, const std::string& port) {
    const Node* reader = node.empty() ? nullptr : document.find(node);
    if (!reader || reader->type != reroute_type) {
        const NodeType* type = node.empty() ? nullptr : model.type_of(node);
        const uint32_t index = type ? type->find_input(port) : NodeType::none;
        if (!node.empty() && (index == NodeType::none || !type->ports[index].is_value()))
            return false;
        return converts(given, wanted_at(model, node, port));
    }
    for (const Connection& wire : fed_by_reroute(document, node))
        if (!converts(given, wanted_at(model, wire.node, wire.port))) return false;
    return true;
}

std::vector<Connection> fed_by_reroute(const Document& document, const std::string& id) {
    std::set<std::string> chain = {id};
    std::vector<Connection> ends;
    for (size_t known = 0; known != chain.size();) {
        known = chain.size();
        ends.clear();
        each_wire(document, [&](const Connection& wire) {
            if (!chain.contains(wire.from.node)) return;
            const Node* reader = wire.node.empty() ? nullptr : document.find(wire.node);
            if (reader && reader->type == reroute_type)
                chain.insert(wire.node);
            else
                ends.push_back(wire);
        });
    }
    return ends;
}

std::optional<Passage> passage(const NodeType& type, PortType given,
                               std::optional<PortType> wanted) {
    std::optional<Passage> best;
    int most = -1;
    for (const Port& in : type.ports) {
        if (!in.is_value() || !converts(given, in.type)) continue;
        for (const Port& out : type.ports) {
            if (out.kind != Port::Kind::output || !converts(out.type, wanted)) continue;
            const int score = 2 * (in.type == given) + (out.type == wanted.value_or(given));
            if (score <= most) continue;
            most = score;
            best = Passage{in.name, out.name};
        }
    }
    return best;
}

Document delete_and_reconnect(const Model& model, const Document& document,
                              const std::set<std::string>& ids) {
    std::vector<Connection> healed;
    each_wire(document, [&](const Connection& wire) {
        if (!ids.contains(wire.from.node) || ids.contains(wire.node)) return;
        const auto from = staying(model, document, ids, wire.from);
        const auto given = from ? model.type_of(*from) : std::nullopt;
        if (given && converts(*given, wanted_at(model, wire.node, wire.port)))
            healed.push_back({*from, wire.node, wire.port});
    });
    Document result = document;
    for (const Connection& wire : healed)
        result = with_wire(result, wire.from, wire.node, wire.port);
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

std::set<std::string> with_upstream(const Document& document, const std::set<std::string>& ids) {
    return walk(document, ids, true);
}

std::set<std::string> with_downstream(const Document& document, const std::set<std::string>& ids) {
    return walk(document, ids, false);
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

}  // namespace wrinkle::editor

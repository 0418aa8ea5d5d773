#include "lower/flat.h"

#include <array>
#include <map>
#include <unordered_map>

#include "base/text.h"
#include "graph/subgraph.h"
#include "lower/mute.h"

namespace wrinkle {
namespace {

// One use of a file: the top graph, or a sub-graph node.
struct Use {
    uint32_t file = 0;
    uint32_t parent = FlatNode::none;  // the enclosing use
    uint32_t node = FlatNode::none;    // the sub-graph node in the parent's document
    uint32_t instance = 0;             // Module::nodes
    std::string prefix;                // "outer/"
    // Flat nodes by node, input and output of the document; none: not visited yet. For an inlined
    // sub-graph's node, its use.
    std::vector<uint32_t> nodes, inputs, outputs;
};

class Flattener {
public:
    Flattener(const Project& project, const Types& types, const FunctionPlan& functions,
              const FlatRoot& root, size_t max_nodes, Lowered& lowered)
        : project_(project),
          types_(types),
          functions_(functions),
          max_nodes_(max_nodes),
          instances_(lowered.module.nodes),
          titles_(lowered.module.titles),
          places_(lowered.places) {
        uses_.push_back(make_use(root.file));
        if (root.instance == 0) {
            reserve(uses_[0].nodes.size() + 1);
        } else {
            uses_[0].instance = root.instance;
            uses_[0].prefix = root.path + "/";
        }
    }

    uint32_t output(uint32_t index) { return output_passthrough(0, index); }

    // Follows the wires of visited nodes, which may visit more. Returns false for too many nodes.
    bool run() {
        for (uint32_t i = 0; i < graph_.nodes.size(); ++i) {
            if (graph_.nodes.size() > max_nodes_) return false;
            fill(i);
        }
        return true;
    }

    FlatGraph take() { return std::move(graph_); }

private:
    const Document& document(uint32_t use) const {
        return project_.files[uses_[use].file].document;
    }

    // Reserves memory for a top graph without sub-graphs; others take more.
    void reserve(size_t nodes) {
        constexpr size_t wires_of_a_node = 6;
        graph_.nodes.reserve(nodes);
        graph_.wires.reserve(nodes * wires_of_a_node);
        instances_.reserve(nodes);
        places_.reserve(nodes);
        origins_.reserve(nodes);
    }

    Use make_use(uint32_t file) const {
        const Document& document = project_.files[file].document;
        Use use;
        use.file = file;
        use.nodes.assign(document.nodes.size(), FlatNode::none);
        use.inputs.assign(document.inputs.size(), FlatNode::none);
        use.outputs.assign(document.outputs.size(), FlatNode::none);
        return use;
    }

    uint32_t add_instance(uint32_t use, uint32_t node, const NodeType& type) {
        NodeInstance& instance = instances_.emplace_back();
        instance.path = uses_[use].prefix + document(use).nodes[node]->id;
        instance.title = title_of(type);
        places_.push_back({uses_[use].file, node});
        return static_cast<uint32_t>(instances_.size() - 1);
    }

    uint32_t title_of(const NodeType& type) {
        const auto [known, added] = title_of_type_.try_emplace(&type, 0);
        if (added) known->second = titles_.add(type.title);
        return known->second;
    }

    uint32_t inner_use(uint32_t use, uint32_t node) {
        if (uses_[use].nodes[node] != FlatNode::none) return uses_[use].nodes[node];
        const uint32_t file = project_.files[uses_[use].file].subgraphs[node];
        Use inner = make_use(file);
        inner.parent = use;
        inner.node = node;
        inner.instance = add_instance(use, node, types_.subgraph(file));
        inner.prefix = instances_.back().path + "/";
        const auto index = static_cast<uint32_t>(uses_.size());
        uses_[use].nodes[node] = index;
        uses_.push_back(std::move(inner));
        return index;
    }

    // Source of a flat node's wires in the project.
    struct Origin {
        enum class Kind : uint8_t { node, input, output } kind;
        uint32_t use = FlatNode::none;    // use with the node, or with the output
        uint32_t inner = FlatNode::none;  // input: the use that has it
        uint32_t index = FlatNode::none;  // index of that input or output
    };

    uint32_t add_node(FlatNode node, uint32_t wires, Origin origin) {
        node.first_wire = static_cast<uint32_t>(graph_.wires.size());
        graph_.wires.resize(graph_.wires.size() + wires);
        graph_.nodes.push_back(std::move(node));
        origins_.push_back(origin);
        return static_cast<uint32_t>(graph_.nodes.size() - 1);
    }

    uint32_t flat_node(uint32_t use, uint32_t node) {
        if (uses_[use].nodes[node] != FlatNode::none) return uses_[use].nodes[node];
        FlatNode flat;
        flat.type = types_.of(uses_[use].file, node);
        flat.document_node = node;
        flat.instance = add_instance(use, node, *flat.type);
        flat.function = project_.files[uses_[use].file].subgraphs[node];
        return uses_[use].nodes[node] = add_node(
                   flat, static_cast<uint32_t>(flat.type->ports.size()), {Origin::Kind::node, use});
    }

    // A muted node or a reroute: the input that it passes to the output; the output if there is
    // none.
    uint32_t passed_port(uint32_t use, uint32_t node, uint32_t output) {
        const Node& source = *document(use).nodes[node];
        const NodeType& type = *types_.of(uses_[use].file, node);
        const uint32_t input = passed_input(type, output, [&](uint32_t port) {
            const Input* written = source.find(type.ports[port].name);
            return written && written->kind == Input::Kind::link;
        });
        const uint32_t port = input == NodeType::none ? output : input;
        const auto [known, added] = passed_ports_.try_emplace({use, node, port});
        if (!added) return known->second;
        uint32_t& first = uses_[use].nodes[node];
        FlatNode flat;
        flat.passthrough = &type.ports[port];
        flat.document_node = node;
        flat.instance =
            first == FlatNode::none ? add_instance(use, node, type) : graph_.nodes[first].instance;
        return first = known->second = add_node(flat, 1, {Origin::Kind::node, use});
    }

    // In the parent graph, a sub-graph's input is a port of the sub-graph's node.
    uint32_t input_passthrough(uint32_t use, uint32_t input) {
        if (uses_[use].inputs[input] != FlatNode::none) return uses_[use].inputs[input];
        FlatNode flat;
        const NodeType& type = types_.subgraph(uses_[use].file);
        flat.passthrough = &type.ports[type.find_input(document(use).inputs[input].name)];
        flat.document_node = uses_[use].node;
        flat.instance = uses_[use].instance;
        return uses_[use].inputs[input] = add_node(
                   std::move(flat), 1, {Origin::Kind::input, uses_[use].parent, use, input});
    }

    Wire node_wire(uint32_t flat, PortType type, uint32_t output) {
        if (!graph_.nodes[flat].is_passthrough())
            graph_.wires[graph_.nodes[flat].first_wire + output].kind = Wire::Kind::output_is_read;
        return {Wire::Kind::node, type, static_cast<uint16_t>(output), flat};
    }

    static Wire surface_wire(const Link& link) {
        const auto properties = surface_properties();
        uint32_t index = 0;
        while (properties[index].name != link.port)
            ++index;
        return {Wire::Kind::surface, properties[index].type, 0, index};
    }

    Wire input_wire(uint32_t use, const Link& link) {
        const auto index = static_cast<uint32_t>(document(use).inputs.index_of(link.port));
        const auto type = *types_.link(uses_[use].file, link);
        if (uses_[use].parent != FlatNode::none)
            return node_wire(input_passthrough(use, index), type, 0);
        return {Wire::Kind::graph_input, type, 0, index};
    }

    // Returns the wire for a link of a use's document. An output of a sub-graph that needs no
    // conversion is replaced by its source.
    Wire follow(uint32_t use, const Link& first, LinkSource source) {
        for (const Link* link = &first;;) {
            if (link->is_surface()) return surface_wire(*link);
            if (link->is_input()) return input_wire(use, *link);
            const auto [node, port] = source;
            const PortType carried = types_.of(uses_[use].file, node)->ports[port].type;
            const Node& read = *document(use).nodes[node];
            if (read.muted || read.type == reroute_type)
                return node_wire(passed_port(use, node, port), carried, 0);
            const uint32_t inner = project_.files[uses_[use].file].subgraphs[node];
            if (inner == Project::File::none || functions_.files[inner].function)
                return node_wire(flat_node(use, node), carried, port);
            use = inner_use(use, node);
            const auto output = static_cast<uint32_t>(document(use).outputs.index_of(link->port));
            link = &document(use).outputs[output].from.link;
            source = types_.source(uses_[use].file, *link);
            if (types_.link(uses_[use].file, *link, source) != carried)
                return node_wire(output_passthrough(use, output), carried, 0);
        }
    }
    Wire follow(uint32_t use, const Link& link) {
        return follow(use, link, types_.source(uses_[use].file, link));
    }

    // run() follows its wire: following it here would nest calls as deep as sub-graphs nest.
    uint32_t output_passthrough(uint32_t use, uint32_t output) {
        if (uses_[use].outputs[output] != FlatNode::none) return uses_[use].outputs[output];
        FlatNode flat;
        const Output& source = document(use).outputs[output];
        Port& port = graph_.output_ports.emplace_back();
        port.name = source.name;
        port.type = types_.output(uses_[use].file, source).value_or(PortType::float_);
        flat.passthrough = &port;
        flat.instance = uses_[use].instance;
        return uses_[use].outputs[output] =
                   add_node(std::move(flat), 1, {Origin::Kind::output, use, use, output});
    }

    void fill(uint32_t index) {
        const FlatNode flat = graph_.nodes[index];
        const Origin origin = origins_[index];
        if (origin.kind == Origin::Kind::output) {
            const Output& source = document(origin.use).outputs[origin.index];
            graph_.wires[flat.first_wire] = follow(origin.use, source.from.link);
        } else if (flat.is_passthrough()) {
            if (flat.passthrough->kind == Port::Kind::output) return;
            Wire wire = port_wire(origin.use, flat.document_node, flat.passthrough->name);
            if (wire.kind == Wire::Kind::none && origin.kind == Origin::Kind::input)
                wire = default_wire(uses_[origin.inner].file, origin.index);
            graph_.wires[flat.first_wire] = wire;
        } else if (flat.function != FlatNode::none) {
            fill_call(flat, origin.use);
        } else {
            fill_ports(flat, origin.use);
        }
    }

    // In the order of the ports, independent of the file's: nodes visited first are named first.
    void fill_ports(const FlatNode& flat, uint32_t use) {
        const std::vector<Port>& ports = flat.type->ports;
        const std::span<const NamedInput> inputs =
            types_.inputs(uses_[use].file, flat.document_node);
        written_.assign(ports.size(), FlatNode::none);
        for (uint32_t i = 0; i < inputs.size(); ++i)
            if (inputs[i].port != NodeType::none) written_[inputs[i].port] = i;
        for (uint32_t p = 0; p < ports.size(); ++p) {
            if (written_[p] == FlatNode::none) continue;
            const Wire wire = ports[p].is_option()
                                  ? option_wire(use, flat.document_node, written_[p])
                                  : port_wire(use, flat.document_node, written_[p]);
            graph_.wires[flat.first_wire + p] = wire;
            if (makes_base(wire) && is_base(ports[p])) graph_.any_own_base = true;
        }
    }

    // A graph's inputs are the first ports of its type, in order.
    void fill_call(const FlatNode& flat, uint32_t use) {
        const std::vector<bool>& needed = functions_.files[flat.function].inputs;
        for (uint32_t p = 0; p < needed.size(); ++p) {
            if (!needed[p]) continue;
            Wire wire = port_wire(use, flat.document_node, flat.type->ports[p].name);
            if (wire.kind == Wire::Kind::none) wire = default_wire(flat.function, p);
            graph_.wires[flat.first_wire + p] = wire;
        }
    }

    Wire port_wire(uint32_t use, uint32_t node, std::string_view port) {
        const Node& source = *document(use).nodes[node];
        const Input* input = source.find(port);
        if (!input) return {};
        return port_wire(use, node, static_cast<uint32_t>(input - source.inputs.data()));
    }

    Wire port_wire(uint32_t use, uint32_t node, uint32_t index) {
        const uint32_t file = uses_[use].file;
        const Input& input = document(use).nodes[node]->inputs[index];
        if (input.kind != Input::Kind::link) return literal_wire(file, input.value);
        return follow(use, input.link, types_.inputs(file, node)[index].source);
    }

    // Returns the literal of an option: its value, or that of the graph input at the end of its
    // links, which lead outwards through sub-graph nodes.
    Wire option_wire(uint32_t use, uint32_t node, uint32_t index) const {
        const Input* input = &document(use).nodes[node]->inputs[index];
        while (input->kind == Input::Kind::link) {
            const Use& inner = uses_[use];
            const std::string& name = input->link.port;
            const bool outermost = inner.parent == FlatNode::none;
            input = outermost ? nullptr : document(inner.parent).nodes[inner.node]->find(name);
            if (!input)
                return default_wire(inner.file,
                                    static_cast<uint32_t>(document(use).inputs.index_of(name)));
            use = inner.parent;
        }
        return literal_wire(uses_[use].file, input->value);
    }

    Wire default_wire(uint32_t file, uint32_t input) const {
        const json::Value& value = project_.files[file].document.inputs[input].default_value;
        if (value.is(json::Kind::null)) return {};
        return literal_wire(file, value);
    }

    static Wire literal_wire(uint32_t file, const json::Value& value) {
        return {Wire::Kind::literal, PortType::float_, 0, file, &value};
    }

    const Project& project_;
    const Types& types_;
    const FunctionPlan& functions_;
    const size_t max_nodes_;
    std::vector<NodeInstance>& instances_;
    StringPool& titles_;
    std::unordered_map<const NodeType*, uint32_t> title_of_type_;
    std::vector<NodePlace>& places_;
    FlatGraph graph_;
    std::vector<Use> uses_;
    std::vector<Origin> origins_;                               // by flat node
    std::map<std::array<uint32_t, 3>, uint32_t> passed_ports_;  // by use, node and port
    std::vector<uint32_t> written_;  // by port: index of the current node's input
};

}  // namespace

std::vector<uint32_t> requested_outputs(const Document& document, const LowerOptions& options,
                                        Diagnostics& diagnostics) {
    std::vector<uint32_t> chosen;
    if (options.outputs.empty())
        for (uint32_t i = 0; i < document.outputs.size(); ++i)
            chosen.push_back(i);
    for (const std::string& name : options.outputs) {
        const Output* output = document.find_output(name);
        if (!output) output = document.find_output(material_output);
        if (!output) {
            diagnostics.add(unknown_output(document, name, keys_of(document.outputs)));
            continue;
        }
        const auto index = static_cast<uint32_t>(output - document.outputs.begin());
        if (std::ranges::find(chosen, index) == chosen.end()) chosen.push_back(index);
    }
    return chosen;
}

Diagnostic unknown_output(const Document& document, const std::string& name,
                          const std::vector<std::string>& names) {
    return diagnose(document, RuleId::unknown_output, "the graph has no output '" + name + "'",
                    did_you_mean(name, names, "it has " + joined(names, ", ")));
}

std::optional<FlatGraph> flatten(const Project& project, const Types& types,
                                 const FunctionPlan& functions, const FlatRoot& root,
                                 size_t max_nodes, Lowered& lowered) {
    Flattener flattener(project, types, functions, root, max_nodes, lowered);
    std::vector<uint32_t> outputs;
    for (const uint32_t index : root.outputs)
        outputs.push_back(flattener.output(index));
    if (!flattener.run()) return {};
    FlatGraph graph = flattener.take();
    graph.outputs = std::move(outputs);
    graph.output_index = root.outputs;
    return graph;
}

Diagnostic diagnose(const Project& project, const NodePlace& place, const std::string& path,
                    RuleId rule, std::string message, std::string expected) {
    const Document& document = project.files[place.file].document;
    if (place.node == NodePlace::none)
        return diagnose(document, rule, std::move(message), std::move(expected));
    Diagnostic diagnostic = diagnose(document, *document.nodes[place.node], rule,
                                     std::move(message), std::move(expected));
    diagnostic.node = path;
    return diagnostic;
}

}  // namespace wrinkle

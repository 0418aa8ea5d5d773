// The nodes that a project's outputs need, with sub-graphs inlined: one list of nodes and wires in
// which every wire converts at most once. Internal to core/lower.
//
// In addition to the nodes of the registry there are pass-through nodes: a sub-graph's input or
// output, a reroute, a port that a muted node passes on. They have one input and one output of one
// type, and exist so that each wire has its own conversion.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "ir/module.h"
#include "lower/functions.h"

namespace wrinkle {

struct Document;
namespace json {
class Value;
}

struct Wire {
    enum class Kind : uint8_t {
        none,         // the port's default
        node,         // an output of a flat node
        surface,      // WR_SURFACE_*
        graph_input,  // an input of the graph that is flattened
        literal,
        output_is_read,  // not a wire: marks an output port that some wire reads
    };
    Kind kind = Kind::none;
    PortType type = PortType::float_;  // type of the value
    uint16_t output = 0;               // port index in the node's type; pass-through: unused
    uint32_t from = 0;  // flat node, surface property, graph input or the literal's file
    const json::Value* literal = nullptr;

    bool carries() const {
        return kind == Kind::node || kind == Kind::surface || kind == Kind::graph_input;
    }
};

struct FlatNode {
    static constexpr uint32_t none = ~0u;
    const NodeType* type = nullptr;     // null: a pass-through
    const Port* passthrough = nullptr;  // port of a pass-through, named as the user knows it
    uint32_t instance = 0;              // Module::nodes
    uint32_t document_node = none;      // in the document that has its wires
    uint32_t first_wire = 0;    // in FlatGraph::wires; one per port of the type, pass-through: one
    uint32_t base_node = none;  // node with the input `base` of conversions at this node's inputs
    uint32_t function = none;   // calls only: the file that is called

    bool is_passthrough() const { return type == nullptr; }
};

struct FlatGraph {
    std::vector<FlatNode> nodes;
    std::vector<Wire> wires;
    std::vector<uint32_t> outputs;       // pass-through of each requested output of the top graph
    std::vector<uint32_t> output_index;  // in the top document's outputs
    std::vector<uint32_t> order;         // every node after those that it reads
    std::deque<Port> output_ports;       // ports of pass-through nodes
    bool any_own_base = false;           // true if has_own_base() for some node

    const Port& port(const FlatNode& node, uint32_t index) const {
        return node.is_passthrough() ? *node.passthrough : node.type->ports[index];
    }
    uint32_t port_count(const FlatNode& node) const {
        return node.is_passthrough() ? 1 : static_cast<uint32_t>(node.type->ports.size());
    }
    const Wire& wire(const FlatNode& node, uint32_t port) const {
        return wires[node.first_wire + port];
    }
};

// The root of flattening: the top graph, or the body of a function as at its first use.
struct FlatRoot {
    uint32_t file = 0;
    uint32_t instance = 0;          // instance of that use, in Module::nodes; 0: the top graph
    std::string path;               // path of that use
    std::vector<uint32_t> outputs;  // requested outputs of the file
};

// The output of type material that is written as one output for each of its channels.
inline constexpr std::string_view material_output = "material";

// Returns the requested outputs of the top graph. A name in options.outputs that is unknown may be
// of a channel of the output `material`, which is then requested; else it is an error.
std::vector<uint32_t> requested_outputs(const Document& document, const LowerOptions& options,
                                        Diagnostics& diagnostics);

Diagnostic unknown_output(const Document& document, const std::string& name,
                          const std::vector<std::string>& names);

// Returns the nodes and wires, with `order` empty; std::nullopt for more than `max_nodes` nodes.
// Appends the instances of the visited nodes to those of `lowered`.
std::optional<FlatGraph> flatten(const Project& project, const Types& types,
                                 const FunctionPlan& functions, const FlatRoot& root,
                                 size_t max_nodes, Lowered& lowered);

// Returns true if the port is a normal input `base`.
inline bool is_base(const Port& port) {
    return port.type == PortType::normal_ && port.kind != Port::Kind::output && port.name == "base";
}

// Returns true if a wire to an input `base` gives another normal than the surface's.
inline bool makes_base(const Wire& wire) {
    return wire.kind == Wire::Kind::node || wire.kind == Wire::Kind::graph_input;
}

// Returns true if such a wire leads to the node: its gradients are then based on that normal.
bool has_own_base(const FlatGraph& graph, const FlatNode& node);

// Sets the base of each conversion to a gradient (base_node), by propagation over gradient wires.
void infer_bases(FlatGraph& graph);

// Fills `order`. Reports an error if the base of a conversion depends on the conversion itself.
void order_nodes(FlatGraph& graph, const Project& project, const Lowered& lowered,
                 Diagnostics& diagnostics);

// Returns a diagnostic at a node instance: its location in its file, its path in the top graph.
Diagnostic diagnose(const Project& project, const NodePlace& place, const std::string& path,
                    RuleId rule, std::string message, std::string expected);

}  // namespace wrinkle

// The nodes that a project's outputs need, with sub-graphs opened up: one list of nodes and wires
// in which every wire converts at most once. For core/lower alone.
//
// Besides the nodes of the registry there are passes: a sub-graph's input or output, a reroute.
// They have one input and one output of one type, and exist so that each wire keeps its own
// conversion.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "ir/module.h"
#include "lower/functions.h"

namespace wrinkle {

struct Wire {
    enum class Kind : uint8_t {
        none,         // the port's default
        node,         // an output of a flat node
        surface,      // WR_SURFACE_*
        graph_input,  // of the graph that is flattened
        literal,
        read,  // of an output, where none begins: a wire leads from it
    };
    Kind kind = Kind::none;
    PortType type = PortType::float_;  // of what it carries
    uint16_t output = 0;               // port index in the node's type; of a pass unused
    uint32_t from = 0;  // flat node, surface property, graph input or the literal's file
    const json::Value* literal = nullptr;

    bool carries() const {
        return kind == Kind::node || kind == Kind::surface || kind == Kind::graph_input;
    }
};

struct FlatNode {
    static constexpr uint32_t none = ~0u;
    const NodeType* type = nullptr;  // of a pass: null
    const Port* pass = nullptr;      // of a pass: its port, named as the user knows it
    bool muted = false;
    uint32_t instance = 0;      // Module::nodes
    uint32_t node = none;       // in the document that has its wires
    uint32_t first_wire = 0;    // in FlatGraph::wires; as many as the type has ports, of a pass one
    uint32_t base_node = none;  // the node whose input `base` holds for this node's conversions
    uint32_t function = none;   // of a call: the file that is called

    bool is_pass() const { return type == nullptr; }
};

struct FlatGraph {
    std::vector<FlatNode> nodes;
    std::vector<Wire> wires;
    std::vector<uint32_t> outputs;  // the pass of each output of the top graph that is asked for
    std::vector<uint32_t> output_index;  // in the top document's outputs
    std::vector<uint32_t> order;         // every node after what it reads
    std::deque<Port> output_ports;       // of passes
    bool bases_are_said = false;         // false: by no node

    const Port& port(const FlatNode& node, uint32_t index) const {
        return node.is_pass() ? *node.pass : node.type->ports[index];
    }
    uint32_t port_count(const FlatNode& node) const {
        return node.is_pass() ? 1 : static_cast<uint32_t>(node.type->ports.size());
    }
    const Wire& wire(const FlatNode& node, uint32_t port) const {
        return wires[node.first_wire + port];
    }
};

// What is flattened: the top graph, or the body of a function as its first use sees it.
struct FlatRoot {
    uint32_t file = 0;
    uint32_t instance = 0;          // of that use, in Module::nodes; 0: the top graph
    std::string path;               // of that use
    std::vector<uint32_t> outputs;  // of the file
};

// The outputs of the top graph that are asked for. Errors: an unknown name in options.outputs.
std::vector<uint32_t> chosen_outputs(const Document& document, const LowerOptions& options,
                                     Diagnostics& diagnostics);

// Of a muted node of the graph (lower/mute.h).
uint32_t passed_input(const FlatGraph& graph, const FlatNode& node, uint32_t output);

// The nodes and wires; `order` is left empty. The instances that are met are appended to those of
// `lowered`. Nothing: more nodes than these.
std::optional<FlatGraph> flatten(const Project& project, const Types& types,
                                 const FunctionPlan& functions, const FlatRoot& root,
                                 size_t max_nodes, Lowered& lowered);

// Whether the port is the one that says a base.
inline bool is_base(const Port& port) {
    return port.type == PortType::normal_ && port.kind != Port::Kind::output && port.name == "base";
}

// Whether the node says a base of its own: a wire that is not the surface's at its input `base`, a
// normal. Its gradients stand on it.
bool says_base(const FlatGraph& graph, const FlatNode& node);

// Which base each conversion to a gradient takes (base_node), over the gradient wires.
void infer_bases(FlatGraph& graph);

// Fills `order`. A conversion whose base depends on the conversion itself is an error.
void order_nodes(FlatGraph& graph, const Project& project, const Lowered& lowered,
                 Diagnostics& diagnostics);

// A diagnostic at a node instance: its place in its file, its path in the whole.
Diagnostic diagnose(const Project& project, const NodePlace& place, const std::string& path,
                    std::string message, std::string expected);

}  // namespace wrinkle

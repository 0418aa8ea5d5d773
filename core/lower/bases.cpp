// Bases of converted inputs, and the build order that they require.
#include <numeric>

#include "graph/depth_first.h"
#include "lower/conversion.h"
#include "lower/flat.h"

namespace wrinkle {
namespace {

constexpr uint32_t none = FlatNode::none;

class Groups {
public:
    explicit Groups(size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    uint32_t find(uint32_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void unite(uint32_t a, uint32_t b) { parent_[find(a)] = find(b); }

private:
    std::vector<uint32_t> parent_;
};

bool makes_gradient(const FlatGraph& graph, const FlatNode& node, uint32_t p) {
    const Port& port = graph.port(node, p);
    const Wire& wire = graph.wire(node, p);
    return port.type == PortType::gradient_ && wire.carries() && wire.type != PortType::gradient_;
}

bool carries_bump(PortType type) {
    return type == PortType::gradient_ || type == PortType::material_;
}

// Returns the node at the other end of a wire; none if there is none.
uint32_t source_of(const Wire& wire) {
    return wire.kind == Wire::Kind::node ? wire.from : none;
}

// Returns the node that makes the base of a node's conversions.
uint32_t base_source(const FlatGraph& graph, const FlatNode& node) {
    if (node.base_node == none) return none;
    const FlatNode& definer = graph.nodes[node.base_node];
    return source_of(graph.wire(definer, definer.type->find_input("base")));
}

Diagnostic base_cycle(const FlatGraph& graph, const FlatNode& node, const Project& project,
                      const Lowered& lowered) {
    const std::vector<NodeInstance>& instances = lowered.module.nodes;
    const std::string& base = instances[graph.nodes[base_source(graph, node)].instance].path;
    const std::string& definer = instances[graph.nodes[node.base_node].instance].path;
    return diagnose(project, lowered.places[node.instance], instances[node.instance].path,
                    RuleId::base_cycle,
                    "its gradient would be based on the normal of node '" + base +
                        "', which is made from it; node '" + definer + "' says that base",
                    "use a node of its own for each of the two bases");
}

}  // namespace

bool has_own_base(const FlatGraph& graph, const FlatNode& node) {
    if (!graph.any_own_base || node.is_passthrough()) return false;
    const uint32_t p = node.type->find_input("base");
    if (p == NodeType::none || !is_base(node.type->ports[p])) return false;
    return makes_base(graph.wire(node, p));
}

void infer_bases(FlatGraph& graph) {
    if (!graph.any_own_base) return;
    const auto count = static_cast<uint32_t>(graph.nodes.size());
    Groups groups(count);
    for (uint32_t i = 0; i < count; ++i)
        for (uint32_t p = 0; p < graph.port_count(graph.nodes[i]); ++p) {
            const Wire& wire = graph.wire(graph.nodes[i], p);
            const bool joins = source_of(wire) != none && carries_bump(wire.type) &&
                               graph.port(graph.nodes[i], p).type == wire.type;
            if (joins) groups.unite(i, wire.from);
        }
    std::vector<uint32_t> definer(count, none);
    for (uint32_t i = 0; i < count; ++i)
        if (has_own_base(graph, graph.nodes[i]) && definer[groups.find(i)] == none)
            definer[groups.find(i)] = i;
    for (uint32_t i = 0; i < count; ++i)
        for (uint32_t p = 0; p < graph.port_count(graph.nodes[i]); ++p)
            if (makes_gradient(graph, graph.nodes[i], p))
                graph.nodes[i].base_node = definer[groups.find(i)];
}

void order_nodes(FlatGraph& graph, const Project& project, const Lowered& lowered,
                 Diagnostics& diagnostics) {
    DepthFirst walk(graph.nodes.size());
    // The edges of a node are its wires, then its base.
    const auto edges = [&](uint32_t node) {
        return graph.port_count(graph.nodes[node]) + (graph.nodes[node].base_node != none ? 1 : 0);
    };
    const auto target = [&](uint32_t index, uint32_t edge) {
        const FlatNode& node = graph.nodes[index];
        if (edge == graph.port_count(node)) return base_source(graph, node);
        return source_of(graph.wire(node, edge));
    };
    // Reading has refused cycles of wires, so there is a base among the edges of this one.
    const auto refuse_bases = [&](uint32_t, uint32_t, uint32_t first) {
        for (auto frame = walk.path().rbegin();; ++frame) {
            FlatNode& node = graph.nodes[frame->node];
            if (node.base_node != none && frame->next_edge > graph.port_count(node)) {
                diagnostics.add(base_cycle(graph, node, project, lowered));
                node.base_node = none;
            }
            if (frame->node == first) return;
        }
    };
    for (const uint32_t output : graph.outputs)
        walk.visit(output, edges, target, refuse_bases);
    graph.order = std::move(walk.order());
}

}  // namespace wrinkle

// Bases of converted inputs, and the build order that they require.
#include <numeric>

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

class Sorter {
public:
    Sorter(FlatGraph& graph, const Project& project, const Lowered& lowered,
           Diagnostics& diagnostics)
        : graph_(graph),
          project_(project),
          lowered_(lowered),
          diagnostics_(diagnostics),
          state_(graph.nodes.size(), State::unseen) {
        graph.order.reserve(graph.nodes.size());
    }

    void run() {
        for (const uint32_t output : graph_.outputs) {
            enter(output);
            while (!stack_.empty())
                step();
        }
    }

private:
    enum class State : uint8_t { unseen, open, done };
    struct Frame {
        uint32_t node;
        uint32_t next;  // index of the next wire; after the wires, the base
    };

    void enter(uint32_t node) {
        if (state_[node] != State::unseen) return;
        state_[node] = State::open;
        stack_.push_back({node, 0});
    }

    void step() {
        Frame& frame = stack_.back();
        const uint32_t index = frame.node;
        const FlatNode& node = graph_.nodes[index];
        const uint32_t wires = graph_.port_count(node);
        while (frame.next < wires) {
            const Wire& wire = graph_.wire(node, frame.next++);
            if (wire.kind == Wire::Kind::node && state_[wire.from] == State::unseen)
                return enter(wire.from);
        }
        if (frame.next++ == wires && node.base_node != none) return enter_base(index);
        state_[index] = State::done;
        graph_.order.push_back(index);
        stack_.pop_back();
    }

    void enter_base(uint32_t index) {
        FlatNode& node = graph_.nodes[index];
        const FlatNode& sayer = graph_.nodes[node.base_node];
        const uint32_t source = graph_.wire(sayer, sayer.type->find_input("base")).from;
        if (state_[source] != State::open) return enter(source);
        const std::vector<NodeInstance>& instances = lowered_.module.nodes;
        const std::string base = instances[graph_.nodes[source].instance].path;
        const std::string other = instances[sayer.instance].path;
        diagnostics_.add(
            diagnose(project_, lowered_.places[node.instance], instances[node.instance].path,
                     "its gradient would stand on the normal of node '" + base +
                         "', which is made from it; node '" + other + "' says that base",
                     "use a node of its own for each of the two bases"));
        node.base_node = none;
    }

    FlatGraph& graph_;
    const Project& project_;
    const Lowered& lowered_;
    Diagnostics& diagnostics_;
    std::vector<State> state_;
    std::vector<Frame> stack_;
};

}  // namespace

bool has_own_base(const FlatGraph& graph, const FlatNode& node) {
    if (!graph.any_own_base || node.is_passthrough() || node.muted) return false;
    const uint32_t p = node.type->find_input("base");
    if (p == NodeType::none || !is_base(node.type->ports[p])) return false;
    return graph.wire(node, p).kind == Wire::Kind::node;
}

void infer_bases(FlatGraph& graph) {
    if (!graph.any_own_base) return;
    const auto count = static_cast<uint32_t>(graph.nodes.size());
    Groups groups(count);
    for (uint32_t i = 0; i < count; ++i)
        for (uint32_t p = 0; p < graph.port_count(graph.nodes[i]); ++p) {
            const Wire& wire = graph.wire(graph.nodes[i], p);
            const bool joins = wire.kind == Wire::Kind::node && wire.type == PortType::gradient_ &&
                               graph.port(graph.nodes[i], p).type == PortType::gradient_;
            if (joins) groups.unite(i, wire.from);
        }
    std::vector<uint32_t> sayer(count, none);
    for (uint32_t i = 0; i < count; ++i)
        if (has_own_base(graph, graph.nodes[i]) && sayer[groups.find(i)] == none)
            sayer[groups.find(i)] = i;
    for (uint32_t i = 0; i < count; ++i)
        for (uint32_t p = 0; p < graph.port_count(graph.nodes[i]); ++p)
            if (makes_gradient(graph, graph.nodes[i], p))
                graph.nodes[i].base_node = sayer[groups.find(i)];
}

void order_nodes(FlatGraph& graph, const Project& project, const Lowered& lowered,
                 Diagnostics& diagnostics) {
    Sorter(graph, project, lowered, diagnostics).run();
}

}  // namespace wrinkle

// Depth-first search of a directed graph with back edges reported and an explicit stack, so that
// deep graphs cannot overflow the call stack. Linear in nodes and edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wrinkle {

class DepthFirst {
public:
    static constexpr uint32_t none = ~0u;

    struct Frame {
        uint32_t node;
        uint32_t next_edge;
    };

    explicit DepthFirst(size_t nodes) : state_(nodes, State::unseen) { order_.reserve(nodes); }

    // Visits all nodes reachable from `root` that earlier calls did not visit.
    //   edge_count(node)                 number of outgoing edges
    //   target(node, edge)               target of an edge; `none`: the edge is skipped
    //   close_cycle(node, edge, target)  called for each back edge, which is not followed; path()
    //                                    ends at `node`. It may set the edge's target to `none` or
    //                                    remove the node's last edge: edges must not be renumbered.
    template <class EdgeCount, class Target, class CloseCycle>
    void visit(uint32_t root, EdgeCount edge_count, Target target, CloseCycle close_cycle) {
        if (state_[root] == State::unseen) enter(root);
        while (!path_.empty()) {
            const auto [node, edge] = path_.back();
            if (edge >= edge_count(node)) {
                leave();
                continue;
            }
            ++path_.back().next_edge;
            const uint32_t to = target(node, edge);
            if (to == none) continue;
            if (state_[to] == State::open) close_cycle(node, edge, to);
            if (state_[to] == State::unseen) enter(to);
        }
    }

    const std::vector<Frame>& path() const { return path_; }  // from the root to the current node
    // Returns the visited nodes in post-order. Without the back edges, each node follows all nodes
    // that it reaches (reverse topological order). The caller may move the vector away.
    std::vector<uint32_t>& order() { return order_; }

private:
    enum class State : uint8_t { unseen, open, done };

    void enter(uint32_t node) {
        state_[node] = State::open;
        path_.push_back({node, 0});
    }
    void leave() {
        state_[path_.back().node] = State::done;
        order_.push_back(path_.back().node);
        path_.pop_back();
    }

    std::vector<State> state_;
    std::vector<Frame> path_;
    std::vector<uint32_t> order_;
};

}  // namespace wrinkle

// Dependencies between nodes: resolved links, evaluation order, cycles, dangling links.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/document.h"

namespace wrinkle {

// Resolved links: the source node of every node input, looked up by name once.
class Wires {
public:
    static constexpr uint32_t none = ~0u;

    explicit Wires(const Document& document);

    // Source node of each input; `none` if the input does not link to a node, or the node does not
    // exist.
    std::span<const uint32_t> of(size_t node) const {
        return std::span(read_).subspan(first_[node], first_[node + 1] - first_[node]);
    }

private:
    std::vector<uint32_t> first_, read_;
};

// Returns the nodes (indices into document.nodes) in topological order: each after the nodes that
// it reads. Depth-first search from the first node; back edges are ignored.
std::vector<uint32_t> evaluation_order(const Document& document);

// Reports an error for each link to a missing node or graph input and for each wire that closes a
// cycle, with the nodes on it; returns the resolved links. Part of read_document; call it again
// after edits.
Wires check_links(const Document& document, Diagnostics& diagnostics);

}  // namespace wrinkle

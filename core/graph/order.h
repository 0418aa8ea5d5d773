// Dependencies between nodes: evaluation order, cycles, dangling links.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/wires.h"

namespace wrinkle {

// Returns the nodes (indices into document.nodes) in topological order: each after the nodes that
// it reads. Depth-first search from the first node, without recursion; back edges are ignored.
std::vector<uint32_t> evaluation_order(const Document& document);

// Reports an error for each link to a missing node or graph input and for each wire that closes a
// cycle, with the nodes on it. Part of read_document; call it again after edits.
void check_links(const Document& document, Diagnostics& diagnostics);
void check_links(const Document& document, const Wires& wires, Diagnostics& diagnostics);

}  // namespace wrinkle

// Who reads whom: evaluation order, cycles, links that lead nowhere.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/wires.h"

namespace wrinkle {

// Every node (its index in document.nodes) after the nodes that it reads. The order is that of a
// depth-first walk from the first node on. A wire that closes a cycle is disregarded. No recursion.
std::vector<uint32_t> evaluation_order(const Document& document);

// Errors for links to nodes, graph inputs that do not exist, and for each
// wire that closes a cycle, with the nodes on it. Part of read_document; an edited one asks again.
void check_links(const Document& document, Diagnostics& diagnostics);
void check_links(const Document& document, const Wires& wires, Diagnostics& diagnostics);

}  // namespace wrinkle

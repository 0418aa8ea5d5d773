// Graphs of two alternating node types in a chain; they expose costs that grow with each link.
#pragma once

#include <string>
#include <vector>

#include "registry/registry.h"

namespace wrinkle::test {

// The built-in node types.
const Registry& registry();

// How one node type reads another.
struct Link {
    const NodeType* from;
    const NodeType* to;
    std::string output;
    std::vector<std::string> inputs;
};

// Every legal connection from one type to the other is one of these: through the one input that
// needs the most work (a field, then a conversion), or through all inputs that take the output's
// type.
enum class Wiring : uint8_t { one_input, all_inputs };

// The link has no inputs if no output of `from` fits an input of `to`.
Link link(const NodeType& from, const NodeType& to, Wiring wiring);

// JSON of a graph with the nodes a, b, a, b ... The first node reads a wave of the surface's uv0,
// and so do inputs that need a wire.
std::string chain(const Link& there, const Link& back, int length);

}  // namespace wrinkle::test

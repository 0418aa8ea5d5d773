// Graphs of two node types in turn, one behind the other: what grows with every link shows here.
#pragma once

#include <string>
#include <vector>

#include "registry/registry.h"

namespace wrinkle::test {

// How one node reads another.
struct Link {
    const NodeType* from;
    const NodeType* to;
    std::string output;
    std::vector<std::string> inputs;
};

// Every legal way from one type to the other is one of these: through one input, the one that takes
// the most work (a field, then a conversion), or through all inputs that take the output's type.
enum class Wiring : uint8_t { one_input, all_inputs };

// No inputs where nothing of `from` fits `to`.
Link link(const NodeType& from, const NodeType& to, Wiring wiring);

// The text of a graph whose nodes are a, b, a, b ... The first reads a wave of the surface's uv0,
// and so do inputs that need a wire.
std::string chain(const Link& there, const Link& back, int length);

}  // namespace wrinkle::test

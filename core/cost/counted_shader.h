// Source for instruction counting: a GLSL 4.50 fragment shader around the function form. The
// members of its struct are interpolants and every output is written, without lighting.
//
// `#line` numbers identify nodes: 1 + the index in Module::nodes, or 1 for a line without a node. A
// helper function has no node; each node that calls it, directly or through other helpers, gets a
// copy of it with the node's line number.
//
// The source has the copies because an instruction that the optimiser inlines has the line of its
// helper, so that it cannot be attributed to a caller.
#pragma once

#include <string>

#include "emit/emit.h"

namespace wrinkle {

std::string counted_shader(const Shader& shader);

// Returns the node of a line; no_node for a line without a node and for the graph itself.
inline uint32_t counted_node(uint32_t line) {
    return line < 2 ? no_node : line - 1;
}

}  // namespace wrinkle

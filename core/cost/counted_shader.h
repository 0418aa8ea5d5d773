// The text whose instructions are counted: a fragment shader of GLSL 4.50 around the function form.
// The members of its struct are interpolants and every output is written, nothing is lit.
//
// A line's number says whose it is: `#line` makes it 1 + the index of its node in Module::nodes, 1
// where it has none. A helper function has no node; each node that calls one gets a copy of
// its own, whose lines are that node's.
#pragma once

#include <string>

#include "glsl/emit.h"

namespace wrinkle {

std::string counted_shader(const Shader& shader);

// The node of a line; no_node of none, and of the graph itself.
inline uint32_t counted_node(uint32_t line) {
    return line < 2 ? no_node : line - 1;
}

}  // namespace wrinkle

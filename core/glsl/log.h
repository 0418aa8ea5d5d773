// What compilers and drivers say of a generated text, brought back to the graph's nodes.
#pragma once

#include <string>
#include <string_view>

#include "glsl/reflection.h"

namespace wrinkle {

// The first line that a log names, as in "0:38(12): ...", "0(38) : ..." or "ERROR: 0:38: ...";
// 0 for none.
size_t line_in(std::string_view log);

// The node that a line of the text came from, counted from 1; no_node where it came from none.
uint32_t node_of_line(const Reflection& reflection, size_t line);

// "<sentence>: <the log's first line>", on the node that the log's line came from.
Problem problem_of_log(const std::string& sentence, std::string_view log,
                       const Reflection& reflection);

}  // namespace wrinkle

// What compilers and drivers say of a generated text, brought back to the graph's nodes.
#pragma once

#include <string>
#include <string_view>

#include "glsl/reflection.h"

namespace wrinkle {

// A line of a log. The place is spelled as drivers and compilers do:
//   "0:38(12): error: ..."  "0(38) : error C1008: ..."  "ERROR: 0:38: ..."   a string of the source
//   "ERROR: a.frag:38: ..." "a.frag:38:5: error: ..."   "a.hlsl(38,5-9): error X3004: ..."  a file
//   "program_source:38:5: error: ..."                                         Metal
struct LogLine {
    size_t line = 0;  // of the text, from 1; 0: it names none
    bool warning = false;
    std::string_view message;  // behind the place; all of it where there is none
};
LogLine read_log_line(std::string_view text);

// The first line that a log names; 0 for none.
size_t line_in(std::string_view log);

// The node that a line of the text came from, counted from 1; no_node where it came from none.
uint32_t node_of_line(const Reflection& reflection, size_t line);

// "<sentence>: <the log's first line>", on the node that the log's line came from.
Problem problem_of_log(const std::string& sentence, std::string_view log,
                       const Reflection& reflection);

}  // namespace wrinkle

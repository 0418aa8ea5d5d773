// Maps the messages of shader compilers and drivers to the graph's nodes.
#pragma once

#include <string>
#include <string_view>

#include "emit/reflection.h"
#include "ir/side_tables.h"

namespace wrinkle {

// A line of a log. Known formats of its location:
//   "0:38(12): error: ..."  "0(38) : error C1008: ..."  "ERROR: 0:38: ..."   a string of the source
//   "ERROR: a.frag:38: ..." "a.frag:38:5: error: ..."   "a.hlsl(38,5-9): error X3004: ..."  a file
//   "program_source:38:5: error: ..."                                         Metal
struct LogLine {
    size_t line = 0;  // source line, from 1; 0: none given
    bool warning = false;
    std::string_view message;  // text after the location; the entire line if there is none
};
LogLine read_log_line(std::string_view text);

// Returns the first source line number in a log; 0 if there is none.
size_t line_in(std::string_view log);

// Returns the node that a source line (counted from 1) came from; no_node if none.
uint32_t node_of_line(const Reflection& reflection, size_t line);

// Returns the problem "<sentence>: <the log's first line>" at the node of the log's first source
// line.
Problem problem_of_log(const std::string& sentence, std::string_view log,
                       const Reflection& reflection);

}  // namespace wrinkle

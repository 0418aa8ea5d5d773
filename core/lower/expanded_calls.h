// How often sub-graphs are called, all in all.
#pragma once

#include "graph/subgraph.h"

namespace wrinkle {

// Every use of a file counts, and every use inside of it once for each use of that file: what a
// program does that has no functions. Of what the top graph's outputs need; the greatest uint64_t
// stands for more. Linear in the files.
uint64_t expanded_calls(const Project& project);

// An error that names the count where it is above Limit::graph_calls, for programs that run without
// functions. False then. `doing`: "eval", "render".
bool may_expand(const Project& project, const std::string& doing, Diagnostics& diagnostics);

}  // namespace wrinkle

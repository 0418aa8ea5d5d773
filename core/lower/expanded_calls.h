// The total number of calls of sub-graphs.
#pragma once

#include "graph/subgraph.h"

namespace wrinkle {

// Counts every use of a file, and every use inside of it once for each use of that file: the calls
// of a program without functions. Counts only nodes that the top graph's outputs need; saturates at
// the greatest uint64_t. Linear in the files.
uint64_t expanded_calls(const Project& project);

// For programs that run without functions: reports an error with the count and returns false if it
// is above Limit::graph_calls. `doing`: "eval", "render".
bool may_expand(const Project& project, const std::string& doing, Diagnostics& diagnostics);

}  // namespace wrinkle

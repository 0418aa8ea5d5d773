// Nodes that the outputs of a project need, and the number of calls of sub-graphs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace wrinkle {

class Diagnostics;
struct Project;

// Returns them by file and node. A sub-graph that is used counts with all its outputs.
std::vector<std::vector<bool>> reachable_nodes(const Project& project);

// Returns the project without all other nodes; the files keep their indices, one that is not used
// is empty.
Project reached_part(Project project);

// Counts every use of a file, and every use inside of it once for each use of that file: the calls
// of a program without functions. Counts only nodes that the top graph's outputs need; saturates at
// the greatest uint64_t. Linear in the files.
uint64_t expanded_calls(const Project& project);

// For programs that run without functions: reports an error with the count and returns false if it
// is above Limit::graph_calls. `doing`: "eval", "render".
bool may_expand(const Project& project, const std::string& doing, Diagnostics& diagnostics);

uint64_t saturating_sum(uint64_t a, uint64_t b);

}  // namespace wrinkle

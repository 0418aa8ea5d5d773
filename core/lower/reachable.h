// Returns the nodes that the outputs of a project need, by file and node. A sub-graph that is used
// counts with all its outputs.
#pragma once

#include <vector>

#include "graph/subgraph.h"

namespace wrinkle {

std::vector<std::vector<bool>> reachable_nodes(const Project& project);

// Returns the project without all other nodes; the files keep their indices, one that is not used
// is empty.
Project reached_part(Project project);

}  // namespace wrinkle

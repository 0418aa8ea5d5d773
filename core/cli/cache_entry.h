// Cache entries of `wrinkle compile --cache`: cache key, load and store.
//
// The key is the hash of all inputs of the generated source and the warnings: the program (build
// id), the options, the graph with the values of --set, its sub-graphs and which node uses which,
// the named images (which of them exist, and which names refer to the same file; no shader depends
// on pixels or sizes), and the plugins that define the used nodes. It does not depend on the
// project's location.
#pragma once

#include <string>

#include "cli/compile_graph.h"

namespace wrinkle::cli {

// Returns "" if an input cannot be hashed; such a graph is not cached.
std::string cache_key(const Project& project, const Types& types, const std::string& name,
                      const Compilation& with);

// Loads generated source, reflection, costs and all warnings; returns false on a miss or if the
// entry is incomplete. An entry holds only bytes: the number of texts comes from the options.
bool take_entry(const Compilation& with, const std::string& key, const Project& project,
                CompiledGraph& result);

// Stores the result. A graph with more warnings than the list holds is not cached. A failed write
// is reported as a warning.
void store_entry(const Compilation& with, const std::string& key, const Project& project,
                 CompiledGraph& result);

}  // namespace wrinkle::cli

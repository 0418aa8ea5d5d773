// What `wrinkle compile --cache` keeps of a graph, and when it is the right one.
//
// The key is the sum of everything that the texts and the warnings depend on: this very program,
// the options, the graph with the values of --set, its sub-graphs and which node uses which, the
// images that they name (whether each is there, and which names mean one file; no shader depends on
// pixels or sizes), and the plugins whose nodes are used. Where a project lies does not matter.
#pragma once

#include <string>

#include "cli/compile_graph.h"

namespace wrinkle::cli {

// "" when something cannot be summed: such a graph is not kept.
std::string cache_key(const Project& project, const Types& types, const std::string& name,
                      const Compilation& with);

// Fills in texts, reflection, costs and all warnings; false when there is no whole entry. An entry
// holds bytes only: the command decides how many texts there are and to which files they go.
bool take_entry(const Compilation& with, const std::string& key, const Project& project,
                CompiledGraph& result);

// A graph with more warnings than are listed is not kept. That nothing can be written is a warning.
void store_entry(const Compilation& with, const std::string& key, const Project& project,
                 CompiledGraph& result);

}  // namespace wrinkle::cli

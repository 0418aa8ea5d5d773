// Checks a project against the node types and reports every problem: all nodes of all its files,
// including those that no output needs.
//
// Reading (graph/read.h, graph/subgraph.h) has reported shapes, links to nodes that do not exist
// and cycles; this reports unknown types, ports and keys, literals that do not fit their port,
// values outside a hard range (a warning: they are clamped), images that are missing or outside the
// root, required inputs, links to outputs that do not exist, wires that do not convert, versions.
// No pixel is read.
#pragma once

#include "graph/named_files.h"
#include "lower/types.h"

namespace wrinkle {

struct CheckOptions {
    bool reachable_only = false;  // only nodes that the top graph's outputs need (live preview)
    NamedFiles* files = nullptr;  // known files of the project; null: none yet
};

void check(const Project& project, const Registry& registry, Diagnostics& diagnostics,
           const CheckOptions& options = {});
void check(const Project& project, const Registry& registry, const Types& types,
           Diagnostics& diagnostics, const CheckOptions& options = {});

}  // namespace wrinkle

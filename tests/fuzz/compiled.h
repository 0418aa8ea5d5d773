// Compiles a graph as the programs do.
#pragma once

#include <string>

#include "graph/document.h"
#include "registry/registry.h"

namespace wrinkle::fuzz {

Registry with_built_in_nodes();

// Compiles to source and to a CPU program. Returns "" on success, or if the graph is rejected with
// an error and `must_compile` is false; otherwise a description of the failure.
std::string wrong_with_compiled(const Document& document, const Registry& registry,
                                bool must_compile);

}  // namespace wrinkle::fuzz

// A graph, compiled as programs do.
#pragma once

#include <string>

#include "graph/document.h"
#include "registry/registry.h"

namespace wrinkle::fuzz {

Registry with_built_in_nodes();

// "" where the graph becomes a text and a program for the CPU, or is refused with an error and need
// not compile; else what went wrong.
std::string wrong_with_compiled(const Document& document, const Registry& registry,
                                bool must_compile);

}  // namespace wrinkle::fuzz

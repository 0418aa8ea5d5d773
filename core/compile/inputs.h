// Every file that a graph reads: itself, its sub-graphs, the images and plugins that its nodes
// name; for build systems, caches and programs that watch their files.
//
// Paths are spelled as the graph was: relative to the working folder where its own path is, so that
// a build system meets the names that it knows. Each file comes once, graphs first.
#pragma once

#include <string>
#include <vector>

#include "graph/subgraph.h"
#include "lower/types.h"

namespace wrinkle {

struct InputFile {
    enum class Kind : uint8_t { graph, image, plugin };
    Kind kind = Kind::graph;
    std::string path;
};

std::string_view name_of(InputFile::Kind kind);

// Without standard input, and without images that lie outside the root. Files may be missing.
std::vector<InputFile> inputs_of(const Project& project, const Types& types);

}  // namespace wrinkle

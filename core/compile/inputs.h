// Lists the input files of a graph: the graph, its sub-graphs, the images and plugins of its nodes,
// and the files of applied presets; for build systems, caches and file watchers.
//
// Paths are spelled like the graph's path: relative to the working folder if that path is, so that
// they match the names in a build system. Each file is listed once, graphs first.
#pragma once

#include <string>
#include <vector>

#include "graph/subgraph.h"
#include "lower/types.h"

namespace wrinkle {

struct InputFile {
    enum class Kind : uint8_t { graph, image, plugin, preset };
    Kind kind = Kind::graph;
    std::string path;
};

std::string_view name_of(InputFile::Kind kind);

// Excludes standard input and images outside the root. Listed files may be missing.
std::vector<InputFile> inputs_of(const Project& project, const Types& types);

}  // namespace wrinkle

// Project: a top graph and the files of its sub-graphs, each read once.
//
// "type": "graph:weave.json" names a file relative to the file that contains it; after
// canonicalisation it must be inside the root. Files that are missing, outside the root or contain
// themselves are errors at the node that names them; that node has no sub-graph here, so the files
// form an acyclic graph. Shared files are stored once: iterate over files, not over uses. In nodes
// that use a sub-graph, former names of its inputs are replaced by the current ones
// (graph/renamed.h).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/read.h"

namespace wrinkle {

struct ProjectOptions {
    std::filesystem::path root;  // "": the top file's folder (`--root`)
    ReadLimits limits;
};

struct Project {
    struct File {
        Document document;
        std::filesystem::path path;  // canonical; folder + "/" for a top document without a name
        // For each node, the index of its sub-graph's file; none: not a sub-graph, or not readable.
        std::vector<uint32_t> subgraphs;
        static constexpr uint32_t none = ~0u;
    };
    std::filesystem::path root;  // canonical
    // In breadth-first order of discovery: [0] is the top, then the files that it names, and so on.
    // For an order with sub-graphs first, see files_in_order() in lower/types.h.
    std::vector<File> files;
    std::vector<std::string> preset_files;  // files of presets applied to the top graph

    const Document& top() const { return files[0].document; }
    // Returns the file of a sub-graph node of files[file]; nullptr if it has none.
    const File* subgraph(size_t file, std::string_view node) const;
};

// Reads a file and its sub-graphs. files[0] always exists; it is empty if the file cannot be read.
Project load_project(const std::filesystem::path& file, const ProjectOptions& options,
                     Diagnostics& diagnostics);

// As above for a top document in memory, which needs no name. Its files are relative to `folder`
// (the folder of its file; the working folder for standard input).
Project load_project(Document top, const std::filesystem::path& folder,
                     const ProjectOptions& options, Diagnostics& diagnostics);

// Returns the canonical path of a file named in files[file], for example an image, if it is inside
// the root; else std::nullopt. The file need not exist.
std::optional<std::filesystem::path> resolve_file(const Project& project, size_t file,
                                                  std::string_view name);

}  // namespace wrinkle

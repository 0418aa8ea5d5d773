// A top graph and the files of its sub-graphs, each read once.
//
// "type": "graph:weave.json" names a file relative to the one that says so; after canonicalisation
// it must stay inside the root. Files that are missing, climb out or contain themselves are errors
// at the node that names them; it has no sub-graph here, so walking the project ends. How often a
// file is used does not matter: walk files, not uses.
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
        std::filesystem::path path;  // canonical; of a top document without a name its folder, "/"
        // For each node the index of its sub-graph's file; none: not a sub-graph, or not readable.
        std::vector<uint32_t> subgraphs;
        static constexpr uint32_t none = ~0u;
    };
    std::filesystem::path root;  // canonical
    std::vector<File> files;     // [0] is the top; a file stands before those it names first

    const Document& top() const { return files[0].document; }
    // The file of a sub-graph node of files[file], nullptr when it has none.
    const File* subgraph(size_t file, std::string_view node) const;
};

// Reads a file and what it names. There is always files[0], empty when it could not be read.
Project load_project(const std::filesystem::path& file, const ProjectOptions& options,
                     Diagnostics& diagnostics);

// The same for a top document in memory, which needs no name. Its files are relative to `folder`
// (that of its file; the working folder for standard input).
Project load_project(Document top, const std::filesystem::path& folder,
                     const ProjectOptions& options, Diagnostics& diagnostics);

// Where a file named in `file` is (an image, say): canonical if inside the root, else nothing.
std::optional<std::filesystem::path> resolve_file(const Project& project, size_t file,
                                                  std::string_view name);

}  // namespace wrinkle

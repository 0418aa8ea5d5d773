// The files that a graph names, when the graph goes to another folder: pictures and sub-graphs are
// named relative to it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "editor/document/model.h"

namespace wrinkle::editor {

struct MovedPaths {
    Document document;                 // names the same files from the new folder
    std::vector<std::string> outside;  // no longer below the folder, so nothing reads them there
};

// Absolute paths stay as they are, and so does what a node of unknown type holds.
MovedPaths move_paths(const Document& document, const Model& model,
                      const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace wrinkle::editor

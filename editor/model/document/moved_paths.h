// Updates file names when a graph is saved in another folder: images and sub-graphs are named
// relative to it. A graph reads only files below its own folder, so a file that is not below the
// new one is copied there or is no longer read.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "editor/model/document/folders.h"
#include "editor/model/document/model.h"

namespace wrinkle::editor {

enum class OutsideFiles : uint8_t {
    referred,  // named at their current location
    copied,    // named at their copy, with the same path relative to the new folder as before
};

struct MovedPaths {
    Document document;                 // names the same files relative to the new folder
    std::vector<std::string> outside;  // below the old folder and not below the new one
    // With `copied`: copy -> original file, including files that sub-graphs name. A copied
    // sub-graph finds its files at the same relative paths as before.
    std::map<std::filesystem::path, std::filesystem::path> copies;
};

// Does not change inputs of nodes of unknown type or absolute paths that are not copied.
MovedPaths move_paths(const Document& document, const Model& model,
                      const std::filesystem::path& from, const std::filesystem::path& to,
                      OutsideFiles files = OutsideFiles::referred);

// Makes MovedPaths::copies. Returns false with the reason in `why`: "there is another weave.png".
// Skips a missing file and a copy that exists with the same bytes.
bool copy_files(const std::map<std::filesystem::path, std::filesystem::path>& copies,
                NewPaths& made, std::string& why);

}  // namespace wrinkle::editor

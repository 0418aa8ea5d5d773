// The files that a graph names, when the graph goes to another folder: pictures and sub-graphs are
// named relative to it. A graph reads files below its own folder only, so what is not below the new
// one is copied there, or is no longer read.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "editor/document/model.h"

namespace wrinkle::editor {

enum class OutsideFiles : uint8_t {
    referred,  // named where they are
    copied,    // named where a copy of them belongs: as far below the new folder as below the old
};

struct MovedPaths {
    Document document;                 // names the same files from the new folder
    std::vector<std::string> outside;  // below the old folder and not below the new one
    // With `copied`: from the place of each copy to the file, also of what sub-graphs name. Such a
    // sub-graph reads its own files below the new folder as it did below the old one.
    std::map<std::filesystem::path, std::filesystem::path> copies;
};

// What a node of unknown type holds stays as it is, and so do absolute paths that are not copied.
MovedPaths move_paths(const Document& document, const Model& model,
                      const std::filesystem::path& from, const std::filesystem::path& to,
                      OutsideFiles files = OutsideFiles::referred);

// Files copied for a graph that is written next; taken away again unless they are kept.
class NewCopies {
public:
    NewCopies() = default;
    NewCopies(const NewCopies&) = delete;
    NewCopies& operator=(const NewCopies&) = delete;
    ~NewCopies();

    // Makes MovedPaths::copies. False with the reason in `why`: "there is another weave.png". A
    // missing file is passed over, and so is a copy that exists with the same bytes.
    bool make(const std::map<std::filesystem::path, std::filesystem::path>& copies,
              std::string& why);
    void keep() { made_.clear(); }

private:
    bool make_one(const std::filesystem::path& from, const std::filesystem::path& to,
                  std::string& why);

    std::vector<std::filesystem::path> made_;  // a folder before what is in it
};

}  // namespace wrinkle::editor

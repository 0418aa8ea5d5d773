// The files that a project's graphs name (images, say), each looked for on disk once.
//
// What a name leads to is asked of the system in as few calls as can be: a folder is resolved once,
// and a file in it that is no link is known by one more.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/subgraph.h"

namespace wrinkle {

class NamedFiles {
public:
    struct Found {
        std::optional<std::filesystem::path> path;  // canonical; nothing: outside the root
        std::filesystem::file_type type = std::filesystem::file_type::none;
    };

    explicit NamedFiles(const Project& project)
        : project_(&project), found_(project.files.size()), folders_(project.files.size()) {}

    // As named in files[file]. Stays valid.
    const Found& find(size_t file, std::string_view name);

private:
    template <class T>
    using ByName = std::map<std::string, T, std::less<>>;

    std::optional<Found> plain_file(size_t file, std::string_view name);

    const Project* project_;
    std::vector<ByName<Found>> found_;  // by file and name
    // By file, and folder as it stands in names: the canonical one; nothing: outside the root.
    std::vector<ByName<std::optional<std::filesystem::path>>> folders_;
};

}  // namespace wrinkle

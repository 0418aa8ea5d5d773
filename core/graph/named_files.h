// Cache of the files that a project's graphs name (images, for example): each is resolved once.
//
// Few system calls: a folder is resolved once, and a file in it that is not a link costs one more
// call.
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
        std::optional<std::filesystem::path> path;  // canonical; std::nullopt: outside the root
        std::filesystem::file_type type = std::filesystem::file_type::none;
    };

    explicit NamedFiles(const Project& project)
        : project_(&project), found_(project.files.size()), folders_(project.files.size()) {}

    // `name` is as written in files[file]. The reference stays valid.
    const Found& find(size_t file, std::string_view name);

private:
    template <class T>
    using ByName = std::map<std::string, T, std::less<>>;

    std::optional<Found> plain_file(size_t file, std::string_view name);

    const Project* project_;
    std::vector<ByName<Found>> found_;  // by file and name
    // By file, and folder as spelled in names: canonical path; std::nullopt: outside the root.
    std::vector<ByName<std::optional<std::filesystem::path>>> folders_;
};

}  // namespace wrinkle

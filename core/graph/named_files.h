// Cache of the files that a project's graphs name (images, for example): each is resolved once.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "graph/subgraph.h"

namespace wrinkle {

class NamedFiles {
public:
    struct Found {
        std::optional<std::filesystem::path> path;  // canonical; std::nullopt: outside the root
        std::filesystem::file_type type = std::filesystem::file_type::none;
    };

    explicit NamedFiles(const Project& project) : project_(&project) {}

    // `name` is as written in files[file]. The reference stays valid.
    const Found& find(size_t file, std::string_view name);

private:
    const Project* project_;
    std::map<std::pair<size_t, std::string>, Found> found_;  // by file and name
};

}  // namespace wrinkle

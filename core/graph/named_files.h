// The files that a project's graphs name (images, say), each looked for on disk once.
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
        : project_(&project), found_(project.files.size()) {}

    // As named in files[file]. Stays valid.
    const Found& find(size_t file, std::string_view name);

private:
    const Project* project_;
    std::vector<std::map<std::string, Found, std::less<>>> found_;  // by file and name
};

}  // namespace wrinkle

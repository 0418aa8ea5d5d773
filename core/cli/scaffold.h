// Files written by `wrinkle new-plugin`: a node with its graph, test and build.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::cli {

struct ScaffoldFile {
    std::string name, text;
};

// Precondition: `name` is a valid node id. `prefix` is the install or build folder of the SDK, ""
// if unknown.
std::vector<ScaffoldFile> scaffold(std::string_view name, std::string_view prefix);

}  // namespace wrinkle::cli

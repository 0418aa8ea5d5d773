// The files that `wrinkle new-plugin` writes: a node with its graph, its test and its build.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::cli {

struct ScaffoldFile {
    std::string name, text;
};

// `name` is the node's id, fit to be one. `prefix` is where the SDK is installed or built, "" when
// that is not known.
std::vector<ScaffoldFile> scaffold(std::string_view name, std::string_view prefix);

}  // namespace wrinkle::cli

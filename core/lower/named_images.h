// The images that one file of a project names, in the order of its nodes and then of its inputs:
// every literal at a port of type image, whether an output needs it or not. Does not check that
// they exist.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lower/types.h"

namespace wrinkle {

struct NamedImage {
    std::string name;                           // as written, relative to the file that names it
    std::optional<std::filesystem::path> path;  // canonical; std::nullopt: outside the root
};

std::vector<NamedImage> named_images(const Project& project, const Types& types, size_t file);

}  // namespace wrinkle

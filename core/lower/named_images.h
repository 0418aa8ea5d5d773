// The images that one file of a project names, in the order of its nodes and then of its inputs:
// every literal at a port of type image, whether an output needs it or not. Does not check that
// they exist.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "graph/named_files.h"
#include "lower/types.h"

namespace wrinkle {

struct NamedImage {
    std::string name;                           // as written, relative to the file that names it
    std::optional<std::filesystem::path> path;  // canonical; std::nullopt: outside the root
};

struct ImageFault {
    RuleId rule;
    std::string text;  // "which does not exist"
    std::string expected;
};

// Returns std::nullopt if the file is a regular one below the root.
std::optional<ImageFault> image_fault(const NamedFiles::Found& found,
                                      const std::filesystem::path& root);

std::vector<NamedImage> named_images(const Project& project, const Types& types, size_t file);

}  // namespace wrinkle

// Which node reads a picture, told by its pixels; where they do not say, by its name.
//
//   equal channels                       height_map
//   unit vectors, all pointing up        tangent_normal_map
//   unit vectors to all sides            object_normal_map; cube_normal_map: six squares in a row
//   two channels, or a constant blue     derivative_map
//   anything else                        image
//
// Unit vectors: 90 % of the pixels, read as 2 c - 1, are 0.9 to 1.1 long. Up: 99 % have z > 0.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "image/image.h"

namespace wrinkle::editor {

struct ImageKind {
    std::string_view node_type;  // "tangent_normal_map"
    std::string why;             // "98 % of its pixels are unit vectors that point up"
};

// By a sample of at most 65,536 pixels; `name` is the file's without its folder.
ImageKind kind_of(const Image& image, std::string_view name);

// Of a file; nothing, with a sentence in `problem`, when it is no picture. One of more than 64
// million pixels is judged by its name, so that nobody waits.
std::optional<ImageKind> kind_of_file(const std::filesystem::path& file, std::string& problem);

}  // namespace wrinkle::editor

// Selects the node type that reads an image, by the classification of maps/lint.h; if that gives no
// result, by the file name.
//
//   height                      height_map
//   normal_gl, normal_dx, normal   tangent_normal_map, green as detected
//   normal_object               object_normal_map; cube_normal_map: six squares in a row
//   two_channel                 derivative_map
//   color                       by its name, else image
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/texture_options.h"
#include "editor/model/images/images.h"

namespace wrinkle::editor {

struct ImageKind {
    std::string_view node_type;        // "tangent_normal_map"
    std::string why;                   // "tangent-space normal map, green up: curl +0.87"
    std::optional<Encoding> encoding;  // std::nullopt: the node's default
};

// `name` is the file name without its folder. Precondition: the file could be read.
ImageKind kind_of(const Examined& examined, std::string_view name);

}  // namespace wrinkle::editor

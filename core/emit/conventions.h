// Conventions that hosts disagree on, chosen for a generated text. Everything between its inputs
// and its results follows the same conventions, those of docs/graph-format.md.
//
//   uv origin   bottom: v points up and the first row of an uploaded image is its bottom row;
//               top: v points down and the first row is the top one
//   normals     space of the function's outputs of type normal. World and view: the object's normal
//               times the member normal_matrix. Tangent: m with normal ~ m.x T + m.y B + m.z N, T
//               and B of uv0, B up in the image (ir/tangent_space.h).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace wrinkle {

enum class UvOrigin : uint8_t { bottom, top };
enum class NormalSpace : uint8_t { object, world, view, tangent };

inline constexpr std::array<std::string_view, 2> uv_origin_names = {"bottom", "top"};

inline constexpr std::array<std::string_view, 4> normal_space_names = {"object", "world", "view",
                                                                       "tangent"};

constexpr std::string_view name_of(UvOrigin origin) {
    return uv_origin_names[static_cast<size_t>(origin)];
}

constexpr std::string_view name_of(NormalSpace space) {
    return normal_space_names[static_cast<size_t>(space)];
}

}  // namespace wrinkle

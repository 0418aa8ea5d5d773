// Conventions that hosts disagree on, chosen for a generated text. Everything between its inputs
// and its results follows the same conventions, those of docs/graph-format.md.
//
//   uv origin   bottom: v points up and the first row of an uploaded image is its bottom row;
//               top: v points down and the first row is the top one
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace wrinkle {

enum class UvOrigin : uint8_t { bottom, top };

inline constexpr std::array<std::string_view, 2> uv_origin_names = {"bottom", "top"};

constexpr std::string_view name_of(UvOrigin origin) {
    return uv_origin_names[static_cast<size_t>(origin)];
}

}  // namespace wrinkle

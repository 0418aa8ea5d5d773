// Effect of a back face on the surface normal n and on the sign of bumps: one choice per graph.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace wrinkle {

enum class BackFaces : uint8_t {
    mirror,  // n is flipped towards the viewer; bumps point outward on both sides
    flip,    // n is flipped; a bump seen from behind is a dent (a thin sheet)
    none,    // n is not changed
};

// Spelling in graph files, in the order of the enumerators.
inline constexpr std::array<std::string_view, 3> back_faces_names = {"mirror", "flip", "none"};

}  // namespace wrinkle

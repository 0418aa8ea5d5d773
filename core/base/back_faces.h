// What a back face does to the surface's normal n and to the sign of bumps: one choice per graph.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace wrinkle {

enum class BackFaces : uint8_t {
    mirror,  // n turns towards the viewer, bumps stay outward on both sides
    flip,    // n turns, and a bump seen from behind is a dent (a thin sheet)
    none,    // n stays
};

// As a graph file spells them, in the order of the enumerators.
inline constexpr std::array<std::string_view, 3> back_faces_names = {"mirror", "flip", "none"};

}  // namespace wrinkle

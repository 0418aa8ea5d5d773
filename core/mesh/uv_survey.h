// What a bake should know, and tell, of a mesh's uv layout.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "mesh/mesh.h"

namespace wrinkle {

struct UvSurvey {
    size_t triangles = 0;
    size_t without_area = 0;          // in uv, or with a uv that is no number
    size_t mirrored = 0;              // clockwise in uv
    size_t first_square = 0;          // with area, that reach into [0, 1]^2
    size_t beyond_udim = 0;           // with area, that reach out of the tiles 1001 to 1100
    std::vector<glm::ivec2> squares;  // of UDIM that triangles reach into, by number
};

// The mesh has uv0.
UvSurvey survey_uvs(const Mesh& mesh);

constexpr int udim_number(glm::ivec2 square) {
    return 1001 + square.x + 10 * square.y;
}

}  // namespace wrinkle

// A mesh's uv layout as a bake needs it: which squares of uv hold triangles, and what it must warn
// of. A square goes by its lower left corner, whole numbers; linear in the triangles.
//
// UDIM numbers squares 1001 + u + 10 row, u from 0 to 9. Rows count upward from v = 0. In a layout
// that reaches below 0 and never above 1 they count downward: v from -1 to 0 is row 1. So a glTF
// file, whose v is turned over when it is read, keeps the rows of its own v in both cases.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "mesh/mesh.h"

namespace wrinkle {

struct UvSurvey {
    size_t triangles = 0;
    size_t without_area = 0;  // in uv, or with a uv that is no number
    size_t mirrored = 0;      // clockwise in uv
    glm::ivec2 square{0};     // baked without UDIM: (0, 0), unless the whole layout lies in another
    size_t in_square = 0;     // with area, that reach into it
    size_t beyond_udim = 0;   // with area, that reach into squares without a number
    std::vector<glm::ivec2> squares;  // of UDIM that triangles reach into, by number
};

// The mesh has uv0.
UvSurvey survey_uvs(const Mesh& mesh);

inline constexpr int udim_columns = 10;
inline constexpr int udim_rows = 899;  // four digits: 1001 to 9990

// The number of one of UvSurvey::squares.
constexpr int udim_number(glm::ivec2 square) {
    return 1001 + square.x + udim_columns * (square.y < 0 ? -square.y : square.y);
}

}  // namespace wrinkle

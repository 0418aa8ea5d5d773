// Survey of a mesh's uv layout for a bake: the unit squares of uv that triangles overlap, and
// counts for warnings; and the scale of the layout. A square is identified by its lower left
// corner, two integers. Linear in the triangles.
//
// UDIM numbers tiles 1001 + u + 10 row, u from 0 to 9. Rows count upward from v = 0. If the layout
// extends below 0 and never above 1, they count downward: v from -1 to 0 is row 1. So a glTF file,
// which has v flipped when it is read, keeps the rows of its original v in both cases.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "mesh/mesh.h"

namespace wrinkle {

struct UvSurvey {
    size_t triangles = 0;
    size_t without_area = 0;  // zero uv area, or a non-finite uv
    size_t mirrored = 0;      // clockwise in uv
    glm::ivec2 square{0};     // baked without UDIM: the only square with triangles, else (0, 0)
    size_t in_square = 0;     // triangles with area that overlap it
    size_t beyond_udim = 0;   // triangles with area that overlap unnumbered squares
    std::vector<glm::ivec2> udim_tiles;  // with triangles, sorted by number
};

// Precondition: the mesh has uv0.
UvSurvey survey_uvs(const Mesh& mesh);

// Returns the length of a uv unit of uv0 in object space: the square root of the surface's area
// over its area in uv; 0 if the mesh has no uv0 or no area in uv.
double uv_length(const Mesh& mesh);

inline constexpr int udim_columns = 10;
inline constexpr int udim_rows = 899;  // four digits: 1001 to 9990

// Returns the UDIM number of an element of UvSurvey::udim_tiles.
constexpr int udim_number(glm::ivec2 tile) {
    return 1001 + tile.x + udim_columns * (tile.y < 0 ? -tile.y : tile.y);
}

}  // namespace wrinkle

// Building blocks of the built-in shapes: vertices with a tangent frame, and grids of them.
#pragma once

#include "mesh/mesh.h"

namespace wrinkle {

struct ShapeVertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec3 tangent;
    glm::vec2 uv;
};

// Adds a vertex with color0 white and uv1 as defined in shapes.h; returns its index.
uint32_t add_vertex(Mesh& mesh, const ShapeVertex& vertex);
void add_triangle(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c);

// Adds a grid of columns * rows quads; calls `vertex(i, j)` for 0 <= i <= columns, 0 <= j <= rows.
template <typename F>
void add_grid(Mesh& mesh, int columns, int rows, F vertex) {
    const auto first = static_cast<uint32_t>(mesh.vertex_count());
    const auto width = static_cast<uint32_t>(columns) + 1;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            add_vertex(mesh, vertex(i, j));
    for (uint32_t j = 0; j < static_cast<uint32_t>(rows); ++j)
        for (uint32_t i = 0; i + 1 < width; ++i) {
            const uint32_t a = first + j * width + i;
            add_triangle(mesh, a, a + 1, a + width + 1);
            add_triangle(mesh, a, a + width + 1, a + width);
        }
}

Mesh make_teapot();

}  // namespace wrinkle

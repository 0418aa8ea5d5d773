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

// Adds a surface of revolution; calls `vertex(column, row)` for rows 0 to `rows`. A first or last
// row of radius 0 has one triangle per column; its vertex is at the middle of the column.
template <typename F>
void add_revolution(Mesh& mesh, int columns, int rows, bool from_pole, bool to_pole, F vertex) {
    const int first = from_pole ? 1 : 0, last = to_pole ? rows - 1 : rows;
    const auto start = static_cast<uint32_t>(mesh.vertex_count());
    add_grid(mesh, columns, last - first, [&](int i, int j) { return vertex(i, first + j); });
    const uint32_t top = start + static_cast<uint32_t>((last - first) * (columns + 1));
    for (uint32_t i = 0; i < static_cast<uint32_t>(columns); ++i) {
        if (from_pole)
            add_triangle(mesh, add_vertex(mesh, vertex(i + 0.5, 0)), start + i + 1, start + i);
        if (to_pole)
            add_triangle(mesh, add_vertex(mesh, vertex(i + 0.5, rows)), top + i, top + i + 1);
    }
}

Mesh make_teapot();

}  // namespace wrinkle

#include "mesh/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "mesh/shape_parts.h"

namespace wrinkle {
namespace {

using glm::vec2;
using glm::vec3;

constexpr int around = 128;  // segments of a full circle; even, so that the front has a vertex
constexpr double pi = std::numbers::pi;

// Sine and cosine of step / steps of a turn, exactly periodic: seams match bit by bit.
struct Turn {
    double sin, cos;
};

Turn turn(double step, int steps) {
    const double angle = 2 * pi * std::fmod(step, steps) / steps;
    return {std::sin(angle), std::cos(angle)};
}

// Longitude with the seam at -z: u = 0.5 faces +z, increasing u turns towards +x.
Turn longitude(double step) {
    const Turn t = turn(step, around);
    return {-t.sin, -t.cos};
}

Mesh make_sphere() {
    Mesh mesh;
    constexpr int rows = around / 2;
    add_revolution(mesh, around, rows, true, true, [](double column, int row) {
        const Turn l = longitude(column);
        const Turn latitude = turn(row, 2 * rows);  // from the south pole
        const double radius = row == 0 || row == rows ? 0 : latitude.sin;
        const vec3 normal(radius * l.sin, -latitude.cos, radius * l.cos);
        return ShapeVertex{normal, normal, vec3(l.cos, 0, -l.sin),
                           vec2(column / around, static_cast<double>(row) / rows)};
    });
    return mesh;
}

// Adds a square with the corners center +- tangent +- cross(normal, tangent).
void add_square(Mesh& mesh, vec3 center, vec3 normal, vec3 tangent, vec2 uv, float uv_side) {
    const vec3 bitangent = glm::cross(normal, tangent);
    add_grid(mesh, 1, 1, [&](int i, int j) {
        const vec2 st(i, j);
        const vec3 offset = (2 * st.x - 1) * tangent + (2 * st.y - 1) * bitangent;
        return ShapeVertex{center + offset, normal, tangent, uv + uv_side * st};
    });
}

Mesh make_plane() {
    Mesh mesh;
    add_square(mesh, vec3(0), vec3(0, 0, 1), vec3(1, 0, 0), vec2(0), 1);
    return mesh;
}

Mesh make_cube() {
    constexpr std::array<vec3, 3> normals{vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)};
    constexpr std::array<vec3, 3> tangents{vec3(0, 0, -1), vec3(1, 0, 0), vec3(1, 0, 0)};
    constexpr float cell = 1.0F / 3;
    Mesh mesh;
    for (size_t axis = 0; axis < 3; ++axis) {
        const vec3 n = normals[axis];
        const float u = static_cast<float>(axis) * cell;
        add_square(mesh, n, n, tangents[axis], vec2(u, 0), cell);
        const vec3 back = axis == 1 ? tangents[axis] : -tangents[axis];
        add_square(mesh, -n, -n, back, vec2(u, cell), cell);
    }
    return mesh;
}

// Adds a disc at height y = +-1 that faces away from the origin.
void add_disc(Mesh& mesh, float y, vec2 uv_center) {
    constexpr float uv_radius = 0.24F;
    const vec3 normal(0, y, 0);
    const auto vertex = [&](float x, float z) {
        return ShapeVertex{vec3(x, y, z), normal, vec3(1, 0, 0),
                           uv_center + uv_radius * vec2(x, -y * z)};
    };
    const uint32_t center = add_vertex(mesh, vertex(0, 0));
    for (int i = 0; i < around; ++i) {
        const Turn l = longitude(i);
        add_vertex(mesh, vertex(static_cast<float>(l.sin), static_cast<float>(l.cos)));
    }
    for (uint32_t i = 0; i < around; ++i) {
        const uint32_t a = center + 1 + i;
        const uint32_t b = center + 1 + (i + 1) % around;
        if (y > 0)
            add_triangle(mesh, center, a, b);
        else
            add_triangle(mesh, center, b, a);
    }
}

Mesh make_cylinder() {
    Mesh mesh;
    add_grid(mesh, around, 1, [](int i, int j) {
        const Turn l = longitude(i);
        const vec3 normal(l.sin, 0, l.cos);
        return ShapeVertex{vec3(normal.x, 2 * j - 1, normal.z), normal, vec3(l.cos, 0, -l.sin),
                           vec2(static_cast<float>(i) / around, 0.5F * static_cast<float>(j))};
    });
    add_disc(mesh, 1, vec2(0.25F, 0.75F));
    add_disc(mesh, -1, vec2(0.75F, 0.75F));
    return mesh;
}

Mesh make_torus() {
    constexpr int rows = around / 2;
    constexpr float ring = 0.7F;
    constexpr float tube = 0.3F;
    Mesh mesh;
    add_grid(mesh, around, rows, [](int i, int j) {
        const Turn l = longitude(i);
        const Turn t = turn(j, rows);
        const vec3 outwards(l.sin, 0, l.cos);
        const vec3 normal(-t.cos * l.sin, -t.sin, -t.cos * l.cos);
        return ShapeVertex{ring * outwards + tube * normal, normal, vec3(l.cos, 0, -l.sin),
                           vec2(static_cast<float>(i) / around, static_cast<float>(j) / rows)};
    });
    return mesh;
}

constexpr std::array<Shape, 6> table{{
    {"sphere", "A ball of radius 1.", make_sphere},
    {"plane", "A square of side 2 that faces +z.", make_plane},
    {"cube", "A box of side 2 with hard edges.", make_cube},
    {"cylinder", "An upright cylinder of radius 1 and height 2.", make_cylinder},
    {"torus", "A lying ring of radius 0.7 with a tube of radius 0.3.", make_torus},
    {"teapot", "Newell's teapot, 1.42 high.", make_teapot},
}};

}  // namespace

uint32_t add_vertex(Mesh& mesh, const ShapeVertex& vertex) {
    mesh.positions.push_back(vertex.position);
    mesh.normals.push_back(vertex.normal);
    mesh.tangents.push_back(glm::vec4(vertex.tangent, 1));
    mesh.uvs[0].push_back(vertex.uv);
    const glm::vec2 p = vertex.uv - 0.5F;
    const glm::vec2 turned(std::sqrt(3.0F) / 2 * p.x - p.y / 2,
                           p.x / 2 + std::sqrt(3.0F) / 2 * p.y);
    mesh.uvs[1].push_back(0.5F + 2.0F * turned);
    mesh.colors.push_back(glm::vec4(1));
    return static_cast<uint32_t>(mesh.vertex_count() - 1);
}

void add_triangle(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

std::span<const Shape> shapes() {
    return table;
}

bool is_shape(std::string_view name) {
    return std::ranges::find(table, name, &Shape::name) != std::end(table);
}

std::optional<Mesh> make_shape(std::string_view name) {
    for (const Shape& shape : table)
        if (shape.name == name) return shape.make();
    return std::nullopt;
}

}  // namespace wrinkle

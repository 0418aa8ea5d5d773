#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "mesh/shapes.h"

namespace wrinkle::test {
namespace {

double area(const Mesh& mesh) {
    double sum = 0;
    for (size_t t = 0; t < mesh.indices.size(); t += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[t]];
        const glm::dvec3 b = mesh.positions[mesh.indices[t + 1]];
        const glm::dvec3 c = mesh.positions[mesh.indices[t + 2]];
        sum += glm::length(glm::cross(b - a, c - a)) / 2;
    }
    return sum;
}

float max_edge(const Mesh& mesh) {
    float longest = 0;
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        const size_t next = i - i % 3 + (i + 1) % 3;
        longest = std::max(longest, glm::distance(mesh.positions[mesh.indices[i]],
                                                  mesh.positions[mesh.indices[next]]));
    }
    return longest;
}

using Place = std::array<float, 3>;
Place place(const Mesh& mesh, size_t corner) {
    const glm::vec3 p = mesh.positions[mesh.indices[corner]] + 0.0F;
    return {p.x, p.y, p.z};
}

// Counts edges, by position, without an edge in the opposite direction: holes and T-junctions.
size_t open_edges(const Mesh& mesh) {
    std::map<std::pair<Place, Place>, int> edges;
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        const Place a = place(mesh, i), b = place(mesh, i - i % 3 + (i + 1) % 3);
        if (a < b)
            ++edges[{a, b}];
        else
            --edges[{b, a}];
    }
    return static_cast<size_t>(
        std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second; }));
}

TEST(Subdivided, KeepsTheShapeAndClosesEverySeam) {
    for (const Shape& shape : shapes()) {
        SCOPED_TRACE(std::string(shape.name));
        const Mesh coarse = shape.make();
        const float longest = 0.6F * max_edge(coarse);
        const Mesh fine = subdivided(coarse, longest);
        EXPECT_GT(fine.triangle_count(), coarse.triangle_count());
        EXPECT_LE(max_edge(fine), longest);
        EXPECT_NEAR(area(fine), area(coarse), 1e-5 * area(coarse));
        EXPECT_TRUE(shape.name == "plane" || open_edges(fine) == open_edges(coarse));
        for (const size_t count : {fine.normals.size(), fine.tangents.size(), fine.uvs[0].size(),
                                   fine.uvs[1].size(), fine.colors.size()})
            EXPECT_EQ(count, fine.vertex_count());
        for (const glm::vec3& normal : fine.normals)
            EXPECT_NEAR(glm::length(normal), 1, 1e-6);
    }
}

TEST(Subdivided, AttributesStayOnTheirPlace) {
    const Mesh fine = subdivided(*make_shape("plane"), 0.1F);
    for (size_t i = 0; i < fine.vertex_count(); ++i) {
        EXPECT_NEAR(fine.uvs[0][i].x, (fine.positions[i].x + 1) / 2, 1e-6);
        EXPECT_NEAR(fine.uvs[0][i].y, (fine.positions[i].y + 1) / 2, 1e-6);
        EXPECT_EQ(fine.tangents[i], glm::vec4(1, 0, 0, 1));
    }
}

TEST(Subdivided, StopsBeforeTooManyTriangles) {
    const Mesh plane = *make_shape("plane");
    EXPECT_LE(subdivided(plane, 1e-9F, 1000).triangle_count(), 1000u);
    EXPECT_EQ(subdivided(plane, 0).triangle_count(), 2u);
    EXPECT_EQ(subdivided(plane, NAN).triangle_count(), 2u);
    EXPECT_EQ(subdivided(Mesh{}, 0.1F).triangle_count(), 0u);
}

}  // namespace
}  // namespace wrinkle::test

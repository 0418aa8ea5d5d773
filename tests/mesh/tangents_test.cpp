#include "mesh/vertex_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "mesh/shapes.h"

namespace wrinkle {
namespace {

using glm::vec2;
using glm::vec3;
using glm::vec4;

// The plane z = 0 with x and y in [-1, 1]; `map` maps positions to uvs.
template <typename F>
Mesh plane_with(F map) {
    Mesh mesh = *make_shape("plane");
    for (vec2& uv : mesh.uvs[0])
        uv = map(uv);
    mesh.tangents.clear();
    return mesh;
}

void expect_all(const Mesh& mesh, vec4 expected) {
    ASSERT_EQ(mesh.tangents.size(), mesh.vertex_count());
    for (const vec4& tangent : mesh.tangents)
        EXPECT_LT(glm::length(tangent - expected), 1e-6)
            << tangent.x << " " << tangent.y << " " << tangent.z << " " << tangent.w;
}

void expect_finite_frames(const Mesh& mesh) {
    ASSERT_EQ(mesh.tangents.size(), mesh.vertex_count());
    for (size_t v = 0; v < mesh.vertex_count(); ++v) {
        const vec3 t(mesh.tangents[v]);
        EXPECT_NEAR(glm::length(t), 1, 1e-5);
        EXPECT_NEAR(glm::dot(t, mesh.normals[v]), 0, 1e-5);
        EXPECT_EQ(std::abs(mesh.tangents[v].w), 1);
    }
}

TEST(Tangents, FollowRotatedMirroredAndSkewedUvs) {
    struct Case {
        vec2 (*map)(vec2);
        vec4 expected;
    };
    const float half = std::sqrt(0.5F);
    const std::vector<Case> cases{
        {[](vec2 p) { return p; }, vec4(1, 0, 0, 1)},
        {[](vec2 p) { return 8.0F * p + 3.0F; }, vec4(1, 0, 0, 1)},
        {[](vec2 p) { return vec2(p.y, -p.x); }, vec4(0, 1, 0, 1)},    // u up, v to the left
        {[](vec2 p) { return vec2(-p.x, p.y); }, vec4(-1, 0, 0, -1)},  // mirrored u
        {[](vec2 p) { return vec2(p.x, -p.y); }, vec4(1, 0, 0, -1)},   // mirrored v
        {[](vec2 p) { return -p; }, vec4(-1, 0, 0, 1)},                // half a turn
        {[](vec2 p) { return vec2(p.y, p.x); }, vec4(0, 1, 0, -1)},
        {[](vec2 p) { return vec2(p.x, p.y - p.x); }, vec4(half, half, 0, 1)},  // skewed
        {[](vec2 p) { return p * 1e-18F; }, vec4(1, 0, 0, 1)},
        {[](vec2 p) { return p * 1e18F; }, vec4(1, 0, 0, 1)},
    };
    for (const Case& c : cases) {
        Mesh mesh = plane_with(c.map);
        ASSERT_TRUE(make_tangents(mesh));
        expect_all(mesh, c.expected);
    }
}

TEST(Tangents, AgreeWithTheShapesOwn) {
    for (const Shape& shape : shapes()) {
        const Mesh exact = shape.make();
        Mesh mesh = exact;
        ASSERT_TRUE(make_tangents(mesh));
        ASSERT_EQ(mesh.vertex_count(), exact.vertex_count()) << "nothing to split";
        // A vertex on a seam sees only half of a segment, so its tangent may deviate by as much.
        const float limit = std::cos(shape.name == "teapot" ? 0.09F : 0.05F);
        for (size_t v = 0; v < mesh.vertex_count(); ++v) {
            ASSERT_GT(glm::dot(vec3(mesh.tangents[v]), vec3(exact.tangents[v])), limit)
                << shape.name << " vertex " << v;
            ASSERT_EQ(mesh.tangents[v].w, exact.tangents[v].w);
        }
        expect_finite_frames(mesh);
    }
}

// Two quads that share an edge; the right one mirrors the uvs of the left one.
Mesh mirrored_pair() {
    Mesh mesh;
    for (int x = -1; x <= 1; ++x)
        for (int y = 0; y <= 1; ++y) {
            mesh.positions.push_back(vec3(x, y, 0));
            mesh.normals.push_back(vec3(0, 0, 1));
            mesh.uvs[0].push_back(vec2(std::abs(x), y));
            mesh.colors.push_back(vec4(x, y, 0, 1));
        }
    mesh.indices = {0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3};
    return mesh;
}

TEST(Tangents, SplitVerticesThatMirroredUvsShare) {
    Mesh mesh = mirrored_pair();
    ASSERT_TRUE(make_tangents(mesh));
    EXPECT_EQ(mesh.vertex_count(), 8U);
    EXPECT_EQ(mesh.colors.size(), 8U);
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        const vec4 expected = i < 6 ? vec4(-1, 0, 0, -1) : vec4(1, 0, 0, 1);
        EXPECT_EQ(mesh.tangents[mesh.indices[i]], expected) << "corner " << i;
    }
    const Mesh before = mirrored_pair();
    for (size_t i = 0; i < mesh.indices.size(); ++i)
        EXPECT_EQ(mesh.positions[mesh.indices[i]], before.positions[before.indices[i]]);
}

TEST(Tangents, NeedUvsAndNormals) {
    Mesh mesh = *make_shape("plane");
    mesh.uvs[0].clear();
    const auto before = mesh.tangents;
    EXPECT_FALSE(make_tangents(mesh));
    EXPECT_EQ(mesh.tangents, before);
    Mesh flat = *make_shape("plane");
    flat.normals.clear();
    EXPECT_FALSE(make_tangents(flat));
}

TEST(Tangents, AreMadeOnlyWhereTheyAreMissing) {
    Mesh mesh = *make_shape("plane");
    mesh.tangents.assign(mesh.vertex_count(), vec4(0, 1, 0, -1));
    ensure_tangents(mesh);
    expect_all(mesh, vec4(0, 1, 0, -1));
    mesh.tangents.clear();
    ensure_tangents(mesh);
    expect_all(mesh, vec4(1, 0, 0, 1));
}

TEST(Tangents, StayFiniteOnDegenerateMeshes) {
    Mesh collapsed = plane_with([](vec2) { return vec2(0.3F, 0.3F); });
    ASSERT_TRUE(make_tangents(collapsed));
    expect_finite_frames(collapsed);

    Mesh line = plane_with([](vec2 p) { return vec2(p.x, p.x); });
    ASSERT_TRUE(make_tangents(line));
    expect_finite_frames(line);

    Mesh point = plane_with([](vec2 p) { return p; });
    point.positions.assign(point.vertex_count(), vec3(2, 3, 4));
    ASSERT_TRUE(make_tangents(point));
    expect_finite_frames(point);

    Mesh along = plane_with([](vec2 p) { return p; });  // the tangent is parallel to the normal
    along.normals.assign(along.vertex_count(), vec3(1, 0, 0));
    ASSERT_TRUE(make_tangents(along));
    expect_finite_frames(along);

    Mesh infinite = plane_with([](vec2 p) { return p / 0.0F; });
    ASSERT_TRUE(make_tangents(infinite));
    expect_finite_frames(infinite);

    Mesh empty;
    EXPECT_FALSE(make_tangents(empty));
}

TEST(Tangents, IgnoreADegenerateTriangleBesideAGoodOne) {
    Mesh mesh = plane_with([](vec2 p) { return p; });
    mesh.indices.insert(mesh.indices.end(), {0, 1, 1, 2, 2, 2});
    ASSERT_TRUE(make_tangents(mesh));
    expect_all(mesh, vec4(1, 0, 0, 1));
}

TEST(Tangents, AreFiniteWhereTheNormalIsZero) {
    Mesh mesh = plane_with([](vec2 p) { return p; });
    mesh.normals.assign(mesh.vertex_count(), vec3(0));
    ASSERT_TRUE(make_tangents(mesh));
    expect_finite_frames(mesh);
}

}  // namespace
}  // namespace wrinkle

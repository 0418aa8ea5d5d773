// Tests of displacement: normals resolved from a height, against the displaced triangles.
#include "bake/displace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "graph/subgraph.h"
#include "lower/material.h"
#include "mesh/mesh.h"
#include "mesh/shapes.h"
#include "support/angle.h"
#include "support/linked_nodes.h"

namespace wrinkle::test {
namespace {

using glm::dvec3;

// A module with the outputs "displacement" and "normal" of the height "h.height" of `nodes`.
Module module_of(const std::string& nodes) {
    const std::string text =
        R"({"wrinkle": 1, "nodes": {)" + nodes +
        R"(, "n": {"type": "resolve", "in": {"gradient": {"from": "h.height"}}}},
           "outputs": {"displacement": {"from": "h.height"}, "normal": {"from": "n.normal"}}})";
    Diagnostics diagnostics;
    const Project project = load_project(read_document(text, "test.json", diagnostics),
                                         WRINKLE_SOURCE_DIR "/graphs", {}, diagnostics);
    MaterialOptions options;
    options.given_differentials = true;
    const Compiled compiled = compile_material(project, linked_nodes(), options, diagnostics);
    EXPECT_TRUE(compiled.ok) << to_text(diagnostics);
    return compiled.module;
}

// Area-weighted normals of the displaced triangles at each vertex; seam vertices get half of them.
std::vector<dvec3> normals_of_triangles(const Mesh& mesh) {
    std::vector<dvec3> sums(mesh.vertex_count(), dvec3(0));
    for (size_t t = 0; t < mesh.indices.size(); t += 3) {
        const auto corner = [&](size_t k) { return dvec3(mesh.drawn()[mesh.indices[t + k]]); };
        const dvec3 normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        for (size_t k = 0; k < 3; ++k)
            sums[mesh.indices[t + k]] += normal;
    }
    return sums;
}

struct Angles {
    double resolved = 0;  // mean angles of the resolved and of
    double bare = 0;      // the bare normals to the triangles
};

Angles compare(Mesh mesh, const std::string& nodes) {
    const Module module = module_of(nodes);
    std::string why;
    const Program program = compile_program(module, why);
    EXPECT_EQ(why, "");
    EXPECT_EQ(displace(mesh, program, 0, {}), "");
    Results results = make_results(program, mesh.vertex_count());
    evaluate<float>(program, vertex_points(mesh, program), {}, 0, mesh.vertex_count(), results);
    const std::vector<dvec3> seen = normals_of_triangles(mesh);
    Angles mean;
    for (size_t i = 0; i < seen.size(); ++i) {
        const double* n = &results.values[1][i * 3];
        mean.resolved += angle_deg(seen[i], {n[0], n[1], n[2]}) / static_cast<double>(seen.size());
        mean.bare += angle_deg(seen[i], dvec3(mesh.normals[i])) / static_cast<double>(seen.size());
    }
    return mean;
}

Mesh fine_plane() {
    return subdivided(*make_shape("plane"), 0.012F);
}

// A sphere without the facets of the shape, which turn normals by up to a degree.
Mesh fine_sphere() {
    Mesh mesh = subdivided(*make_shape("sphere"), 0.02F);
    for (size_t i = 0; i < mesh.vertex_count(); ++i)
        mesh.positions[i] = mesh.normals[i] = glm::normalize(mesh.positions[i]);
    return mesh;
}

std::string noise(const char* amplitude) {
    return R"("h": {"type": "gradient_noise",
                    "in": {"scale": 2, "octaves": 2, "amplitude": )" +
           std::string(amplitude) + "}}";
}

const std::string waves_of_uv =
    R"("t": {"type": "uv_transform", "in": {"scale": [9, 5], "rotation": 20}},
       "s": {"type": "separate_vec2", "in": {"vector": {"from": "t.uv"}}},
       "u": {"type": "sine", "in": {"angle": {"from": "s.x"}}},
       "v": {"type": "cosine", "in": {"angle": {"from": "s.y"}}},
       "p": {"type": "multiply", "in": {"a": {"from": "u.result"}, "b": {"from": "v.result"}}},
       "h": {"type": "height_scale", "in": {"height": {"from": "p.result"}, "amount": 0.1}})";

// A noise from 0 to 1, through a node of this type, times 0.1.
std::string noise_through(const std::string& type, const std::string& port, const std::string& in) {
    return R"("f": {"type": "gradient_noise", "in": {"scale": 2, "octaves": 1}},
       "half": {"type": "multiply_add", "in": {"a": {"from": "f.value"}, "b": 0.5, "c": 0.5}},
       "t": {"type": ")" +
           type + R"(", "in": {")" + port + R"(": {"from": "half.result"}, )" + in + R"(}},
       "h": {"type": "height_scale", "in": {"height": {"from": "t.value"}, "amount": 0.1}})";
}

TEST(Displace, HeightsThroughRampsAndCurvesHaveTheirNormals) {
    const std::pair<const char*, std::string> cases[] = {
        {"ramp", R"("stops": 4, "position_1": 0.2, "position_2": 0.4, "position_3": 0.6,
                    "position_4": 0.8, "color_1": [0.1, 0.1, 0.1], "color_2": [0.9, 0.3, 0.2],
                    "color_3": [0.2, 0.8, 0.4], "interpolation": )"},
        {"curve", R"("points": 4, "point_1": [0.2, 0.1], "point_2": [0.4, 0.5],
                     "point_3": [0.6, 0.4], "point_4": [0.8, 1], "interpolation": )"}};
    for (const auto& [type, in] : cases)
        for (const char* mode : {"\"ease\"", "\"smooth\""}) {
            const std::string port = type == std::string("ramp") ? "factor" : "value";
            const Angles plane = compare(fine_plane(), noise_through(type, port, in + mode));
            EXPECT_LT(plane.resolved, 0.3) << type << mode;
            EXPECT_GT(plane.bare, 5) << type << mode;
        }
}

TEST(Displace, TheResolvedNormalIsThatOfTheMovedTriangles) {
    const Angles plane = compare(fine_plane(), noise("0.15"));
    EXPECT_LT(plane.resolved, 0.3);
    EXPECT_GT(plane.bare, 10);
    const Angles waves = compare(fine_plane(), waves_of_uv);
    EXPECT_LT(waves.resolved, 0.3);
    EXPECT_GT(waves.bare, 8);
    const Angles sphere = compare(fine_sphere(), noise("0.03"));
    EXPECT_LT(sphere.resolved, 0.3);
    EXPECT_GT(sphere.bare, 2);
}

// On a curved surface the normal also turns by a term of the order height / radius, which surface
// gradients omit.
TEST(Displace, TheErrorOnACurvedSurfaceGrowsWithTheHeight) {
    const Angles high = compare(fine_sphere(), noise("0.15"));
    EXPECT_LT(high.resolved, 0.15 * high.bare);
    EXPECT_GT(high.bare, 10);
}

TEST(Displace, MovesAlongTheNormalAndLeavesTheSurfaceAlone) {
    const Mesh before = fine_sphere();
    Mesh mesh = before;
    std::string why;
    Module module = module_of(R"("h": {"type": "height_add", "in": {"a": 0.2, "b": 0.3}})");
    const Program program = compile_program(module, why);
    ASSERT_EQ(displace(mesh, program, 0, {}), "");
    EXPECT_EQ(mesh.positions, before.positions);
    EXPECT_EQ(mesh.normals, before.normals);
    ASSERT_EQ(mesh.displaced.size(), mesh.vertex_count());
    for (const glm::vec3& place : mesh.displaced)
        EXPECT_NEAR(glm::length(place), 1.5, 1e-5);
}

TEST(Displace, VerticesAtOnePlaceStayAtOnePlace) {
    Mesh mesh = *make_shape("cube");
    std::string why;
    const Program program =
        compile_program(module_of(R"("h": {"type": "height_add", "in": {"a": 0.3}})"), why);
    ASSERT_EQ(displace(mesh, program, 0, {}), "");
    for (size_t i = 0; i < mesh.vertex_count(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(mesh.displaced[i][axis], 1.1 * mesh.positions[i][axis], 1e-6);
}

TEST(Displace, SaysWhatTheMeshLacks) {
    Mesh mesh = *make_shape("plane");
    mesh.uvs[0].clear();
    std::string why;
    const Program program = compile_program(module_of(waves_of_uv), why);
    EXPECT_EQ(displace(mesh, program, 0, {}), "the displacement reads 'uv0', which the mesh lacks");
    mesh.normals.clear();
    EXPECT_EQ(displace(mesh, program, 0, {}), "a mesh without normals cannot be displaced");
    EXPECT_TRUE(mesh.displaced.empty());
}

}  // namespace
}  // namespace wrinkle::test

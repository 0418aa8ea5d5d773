// Tests of the OBJ reader: contents of valid files, and errors of invalid ones.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/files.h"

namespace wrinkle::test {
namespace {

const std::string corners = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n";

// Returns the area of the mesh's triangles as seen from +z.
double area_from_above(const Mesh& mesh) {
    double sum = 0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]];
        const glm::dvec3 b = mesh.positions[mesh.indices[i + 1]];
        const glm::dvec3 c = mesh.positions[mesh.indices[i + 2]];
        sum += glm::cross(b - a, c - a).z / 2;
    }
    return sum;
}

TEST(Obj, ReadsPositionsUvsNormalsAndColors) {
    const Loaded file = load(
        "# made by hand\nmtllib none.mtl\no thing\n"
        "v 0 0 0 1 0 0\nv 2 0 0 0 1 0\nv 2 1 0 0 0 1\n"
        "vt 0 0\nvt 1 0\nvt 1 .5e0 0\nvn 0 0 2\nusemtl red\ns 1\n"
        "f 1/1/1 2/2/1 \\\n 3/3/1 # the end\n");
    ASSERT_TRUE(file.mesh) << file.said;
    EXPECT_EQ(file.said, "");
    const Mesh& mesh = *file.mesh;
    ASSERT_EQ(mesh.indices, (std::vector<uint32_t>{0, 1, 2}));
    EXPECT_EQ(mesh.positions[2], glm::vec3(2, 1, 0));
    EXPECT_EQ(mesh.uvs[0][2], glm::vec2(1, 0.5F));
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.colors[1], glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(mesh.tangents[0], glm::vec4(1, 0, 0, 1));
    EXPECT_FALSE(mesh.has_uv(1));
}

TEST(Obj, CountsNegativeIndicesBackwards) {
    const Loaded file = load(corners + "f -4 -3 -2\r\nv 9 9 9\nf -5 -3 -2\n");
    ASSERT_TRUE(file.mesh) << file.said;
    EXPECT_EQ(file.mesh->indices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(file.mesh->positions[3], glm::vec3(0, 1, 0));
}

TEST(Obj, CutsPolygonsIntoTriangles) {
    EXPECT_EQ(load(corners + "f 1 2 3 4\n").mesh->indices,
              (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
    // An L of area 3, with both windings: fans from most corners would leave it.
    const std::string l = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n";
    for (int first = 0; first < 6; ++first) {
        std::string up = "f", down = "f";
        for (int k = 0; k < 6; ++k) {
            up += " " + std::to_string((first + k) % 6 + 1);
            down += " " + std::to_string((first + 6 - k) % 6 + 1);
        }
        const Mesh above = *load(l + up + "\n").mesh;
        EXPECT_EQ(above.triangle_count(), 4U);
        EXPECT_NEAR(area_from_above(above), 3, 1e-6) << up;
        for (size_t t = 0; t < 4; ++t) {
            Mesh one = above;
            one.indices.assign(above.indices.begin() + static_cast<long>(3 * t),
                               above.indices.begin() + static_cast<long>(3 * t + 3));
            EXPECT_GT(area_from_above(one), 0) << up;
        }
        EXPECT_NEAR(area_from_above(*load(l + down + "\n").mesh), -3, 1e-6) << down;
    }
}

TEST(Obj, MakesSmoothNormalsAcrossUvSeams) {
    // Two faces of a roof; the vertices of the ridge have different uvs in each face.
    const std::string roof =
        "v -1 0 0\nv -1 0 1\nv 0 1 0\nv 0 1 1\nv 1 0 0\nv 1 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
        "f 1/1 2/2 4/3 3/4\nf 3/2 4/1 6/4 5/3\n";
    const Loaded file = load(roof);
    ASSERT_TRUE(file.mesh) << file.said;
    const Mesh& mesh = *file.mesh;
    const float half = std::sqrt(0.5F);
    for (size_t v = 0; v < mesh.vertex_count(); ++v) {
        const float x = mesh.positions[v].x;
        const glm::vec3 expected = x == 0 ? glm::vec3(0, 1, 0) : glm::vec3(x * half, half, 0);
        EXPECT_LT(glm::length(mesh.normals[v] - expected), 1e-6) << v;
    }
}

TEST(Obj, FillsWhatSomeFacesLack) {
    const Loaded file = load(corners + "vt .5 .5\nvn 0 0 0\nf 1/1/1 2/1/1 3/1/1\nf 1 3 4\n");
    ASSERT_TRUE(file.mesh) << file.said;
    const Mesh& mesh = *file.mesh;
    EXPECT_EQ(mesh.vertex_count(), 6U);
    EXPECT_EQ(mesh.uvs[0][5], glm::vec2(0));
    for (size_t v = 0; v < 6; ++v) {
        EXPECT_EQ(mesh.normals[v], glm::vec3(0, 0, 1));
        EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[v])), 1, 1e-6);
    }
}

TEST(Obj, KeepsDegenerateAndNonManifoldFaces) {
    const Loaded file =
        load(corners + "v 1 0 5\nf 1 2 3\nf 1 2 5\nf 2 1 4\nf 1 1 2\nf 3 3 3\nf 1 2 3 1\n");
    ASSERT_TRUE(file.mesh) << file.said;
    EXPECT_EQ(file.mesh->triangle_count(), 7U);
    for (const glm::vec3 normal : file.mesh->normals)
        EXPECT_NEAR(glm::length(normal), 1, 1e-6);
}

TEST(Obj, TakesTinyNumbersForZero) {
    const Loaded file = load("v 0 1e-999 1E-50\nv +1 0 0\nv 0 1. 0\nf 1 2 3\n");
    ASSERT_TRUE(file.mesh) << file.said;
    EXPECT_EQ(file.mesh->positions[0], glm::vec3(0));
}

struct Wrong {
    std::string text;
    std::string words;
};

TEST(Obj, SaysWhatIsWrongAndWhere) {
    const std::vector<Wrong> cases = {
        {"", "has no triangles"},
        {"hello\n", "has no triangles"},
        {corners, "has no triangles"},
        {corners + "f 1 1 1\n", "no triangle with an area"},
        {corners + "f 1 2\n", "mesh.obj:5:2: error: a face of 2 corners"},
        {corners + "f 1 2 5\n", "mesh.obj:5:7: error: there is no vertex 5 here"},
        {corners + "f 1 2 -5\n", "mesh.obj:5:7: error: there is no vertex -5"},
        {corners + "f 1 2 99999999999999999999\n", "is not an index of a vertex"},
        {corners + "f 0 1 2\n", "mesh.obj:5:3: error: '0' is not an index of a vertex"},
        {corners + "f 1/1 2/1 3/1\n", "no texture vertex 1"},
        {corners + "f 1//1 2//1 3//1\n", "no vertex normal 1"},
        {corners + "vt 0 0\nvn 0 0 1\nf 1/1/1/1 2 3\n", "more than three indices"},
        {corners + "f a b c\n", "'a' is not an index"},
        {"v 0 nan 0\n", "mesh.obj:1:5: error: 'nan' is not a finite number (v X Y Z"},
        {"v 0 inf 0\n", "'inf' is not a finite number"},
        {"v 0 1e999 0\n", "'1e999' is not a finite number"},
        {"v 0 1e39 0\n", "'1e39' is not a finite number"},
        {"v 0 0\n", "2 numbers where at least 3 belong"},
        {"v 0,5 0 0\n", "'0,5' is not a finite number"},
        {"v 0 0 1e16\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "beyond 1e15"},
        {std::string("v 0 0 0\n\0\0", 10), "is not a mesh file"},
    };
    for (const Wrong& wrong : cases) {
        const Loaded file = load(wrong.text);
        EXPECT_FALSE(file.mesh) << wrong.text;
        EXPECT_NE(file.said.find(wrong.words), std::string::npos) << wrong.text << file.said;
        EXPECT_NE(file.said.find("mesh.obj"), std::string::npos) << file.said;
        EXPECT_NE(file.said.find('('), std::string::npos) << "no remedy: " << file.said;
    }
}

TEST(Obj, StopsAfterAFewProblemsAndAtTheLimit) {
    std::string many;
    for (int i = 0; i < 1000; ++i)
        many += "v x y z\n";
    EXPECT_EQ(load(many).diagnostics.error_count(), 20U);
    MeshFileOptions small;
    small.limits.max_corners = 5;
    EXPECT_NE(load(corners + "f 1 2 3 4\n", "mesh.obj", small).said.find("more than 1 triangles"),
              std::string::npos);
}

}  // namespace
}  // namespace wrinkle::test

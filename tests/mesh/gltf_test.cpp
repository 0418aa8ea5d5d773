// Tests of the glTF reader: contents of valid files, and errors of invalid ones.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "mesh/files.h"
#include "support/files.h"

namespace wrinkle::test {
namespace {

namespace fs = std::filesystem;

Mesh mesh_of(const GltfText& gltf) {
    const Loaded file = load(gltf.text(), "mesh.gltf");
    EXPECT_TRUE(file.mesh) << file.said;
    return file.mesh.value_or(Mesh());
}

std::string material(const std::string& transform, const std::string& texture = "normalTexture") {
    return R"(, "materials": [{")" + texture + R"(": {"index": 0, "extensions": {
        "KHR_texture_transform": {)" +
           transform + R"(}}}}], "textures": [{"source": 0}],
        "images": [{"uri": "none.png"}])";
}

TEST(Gltf, TurnsVOverAndMakesNormalsAndTangents) {
    for (const std::string& bytes : {square().text(), square().glb(), "  \n" + square().text()}) {
        const Loaded file = load(bytes);
        ASSERT_TRUE(file.mesh) << file.said;
        EXPECT_EQ(file.said, "");
        const Mesh& mesh = *file.mesh;
        ASSERT_EQ(mesh.vertex_count(), 4U);
        EXPECT_EQ(mesh.indices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
        for (size_t v = 0; v < 4; ++v) {
            EXPECT_EQ(mesh.uvs[0][v], glm::vec2(mesh.positions[v]));
            EXPECT_EQ(mesh.normals[v], glm::vec3(0, 0, 1));
            EXPECT_EQ(mesh.tangents[v], glm::vec4(1, 0, 0, 1));
        }
    }
}

TEST(Gltf, KeepsAFilesOwnTangents) {
    GltfText gltf = square();
    gltf.add({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    gltf.add({0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1}, "VEC4");
    gltf.attributes += R"(, "NORMAL": 3, "TANGENT": 4)";
    EXPECT_EQ(mesh_of(gltf).tangents[2], glm::vec4(0, 1, 0, -1));
    gltf.attributes = R"("POSITION": 0, "TEXCOORD_0": 1, "TANGENT": 4)";  // unused without normals
    EXPECT_EQ(mesh_of(gltf).tangents[2], glm::vec4(1, 0, 0, 1));
}

TEST(Gltf, ReplacesTangentsAndNormalsThatAreNone) {
    GltfText gltf = square();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    gltf.add({0, 0, 1, 0, 0, 0, nan, 0, 1, 0, 0, 9}, "VEC3");
    gltf.add({0, 1, 0, -1, 0, 1, 0, -1, 0, nan, 0, -1, 0, 1, 0, -1}, "VEC4");
    gltf.attributes += R"(, "NORMAL": 3, "TANGENT": 4)";
    const Loaded file = load(gltf.text());
    ASSERT_TRUE(file.mesh) << file.said;
    EXPECT_NE(file.said.find("2 normals are zero or no numbers"), std::string::npos) << file.said;
    EXPECT_NE(file.said.find("tangents are not unit vectors"), std::string::npos) << file.said;
    for (size_t v = 0; v < 4; ++v) {
        EXPECT_EQ(file.mesh->normals[v], glm::vec3(0, 0, 1));
        EXPECT_EQ(file.mesh->tangents[v], glm::vec4(1, 0, 0, 1));
    }
}

TEST(Gltf, ReadsAllSetsColorsAndQuantisedNumbers) {
    GltfText gltf = square();
    gltf.add_bytes(std::string("\xFF\x00\x00\xFF\xFF\xFF\x00\x80", 8),
                   R"("componentType": 5121, "normalized": true, "count": 4, "type": "VEC2")");
    gltf.add_bytes(std::string(4, '\xFF') + std::string(4, '\0') + std::string(8, '\x33'),
                   R"("componentType": 5121, "normalized": true, "count": 4, "type": "VEC4")");
    gltf.attributes += R"(, "TEXCOORD_1": 3, "TEXCOORD_3": 1, "COLOR_0": 4)";
    const Mesh mesh = mesh_of(gltf);
    EXPECT_EQ(mesh.uvs[1][0], glm::vec2(1, 1));
    EXPECT_NEAR(mesh.uvs[1][3].y, 1 - 128 / 255.0, 1e-6);
    EXPECT_FALSE(mesh.has_uv(2));
    EXPECT_EQ(mesh.uvs[3], mesh.uvs[0]);
    EXPECT_EQ(mesh.colors[0], glm::vec4(1));
    EXPECT_NEAR(mesh.colors[2].w, 0.2, 1e-6);
}

TEST(Gltf, ReadsStripsFansAndUnindexed) {
    GltfText gltf = square();
    gltf.add_indices({0, 1, 3, 2});
    gltf.primitive = R"(, "indices": 3, "mode": 5)";
    EXPECT_EQ(mesh_of(gltf).indices, (std::vector<uint32_t>{0, 1, 3, 1, 2, 3}));
    gltf.primitive = R"(, "mode": 6)";
    EXPECT_EQ(mesh_of(gltf).indices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
    gltf.primitive = R"(, "mode": 4)";
    EXPECT_EQ(mesh_of(gltf).indices, (std::vector<uint32_t>{0, 1, 2}));
}

TEST(Gltf, ResolvesSparseAccessors) {
    GltfText gltf = square();
    gltf.add_indices({2});
    gltf.add({7, 8, 9}, "VEC3");
    std::string text = gltf.text();
    const std::string find = R"("count": 4, "type": "VEC3")";
    text.replace(text.find(find), find.size(), find + R"(, "sparse": {"count": 1,
        "indices": {"bufferView": 3, "componentType": 5123}, "values": {"bufferView": 4}})");
    const Loaded file = load(text);
    ASSERT_TRUE(file.mesh) << file.said;
    EXPECT_EQ(file.mesh->positions[2], glm::vec3(7, 8, 9));
    EXPECT_EQ(file.mesh->positions[3], glm::vec3(0, 1, 0));
}

// The order of the glTF extension: scale, then rotation, then offset, v downwards.
TEST(Gltf, MovesUvsAsTheirMaterialSays) {
    GltfText gltf = square();
    gltf.primitive += R"(, "material": 0)";
    gltf.more = material(R"("offset": [5, 12], "scale": [2, 0.5], "rotation": 1.5707963267948966)");
    const Mesh mesh = mesh_of(gltf);
    // (1, 1) in glTF: scaled (2, 0.5), rotated (0.5, -2), moved (5.5, 10); here v' = 1 - v.
    EXPECT_LT(glm::length(mesh.uvs[0][1] - glm::vec2(5.5F, 1 - 10)), 1e-5);
    EXPECT_LT(glm::length(mesh.uvs[0][3] - glm::vec2(5, 1 - 12)), 1e-5);
    // u grows along glTF's former v: down the quad.
    EXPECT_LT(glm::length(mesh.tangents[0] - glm::vec4(0, -1, 0, 1)), 1e-5);
    gltf.more = material(R"("offset": [0.25, 0], "texCoord": 1)");
    gltf.attributes += R"(, "TEXCOORD_1": 1)";
    EXPECT_EQ(mesh_of(gltf).uvs[0][0], glm::vec2(0));
    EXPECT_EQ(mesh_of(gltf).uvs[1][0], glm::vec2(0.25F, 0));
}

TEST(Gltf, MakesTangentsAnewWhereUvsTurn) {
    GltfText gltf = square();
    gltf.add({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    gltf.add({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4");
    gltf.attributes += R"(, "NORMAL": 3, "TANGENT": 4)";
    gltf.primitive += R"(, "material": 0)";
    gltf.more = material(R"("scale": [-2, 2])");
    EXPECT_EQ(mesh_of(gltf).tangents[0], glm::vec4(-1, 0, 0, -1));
    gltf.more = material(R"("scale": [2, 3])");
    EXPECT_EQ(mesh_of(gltf).tangents[0], glm::vec4(1, 0, 0, 1));
}

TEST(Gltf, WarnsWhereTexturesMoveOneSetDifferently) {
    GltfText gltf = square();
    gltf.primitive += R"(, "material": 0)";
    gltf.more = R"(, "materials": [{"normalTexture": {"index": 0}, "emissiveTexture": {"index": 0,
        "extensions": {"KHR_texture_transform": {"scale": [3, 3]}}}}])";
    const Loaded file = load(gltf.text());
    ASSERT_TRUE(file.mesh) << file.said;
    EXPECT_NE(file.said.find("move one uv set in different ways"), std::string::npos) << file.said;
    EXPECT_EQ(file.mesh->uvs[0][2], glm::vec2(1, 1));
}

TEST(Gltf, PutsNodesWhereTheirTransformsSay) {
    GltfText gltf = square();
    gltf.nodes = R"([{"translation": [10, 0, 0], "children": [1, 2]},
        {"mesh": 0, "scale": [2, 1, 1], "rotation": [0, 0, 0.70710678, 0.70710678]},
        {"mesh": 0, "matrix": [-1, 0, 0, 0,  0, 1, 0, 0,  0, 0, 1, 0,  0, 0, 3, 1]}])";
    const Mesh mesh = mesh_of(gltf);
    ASSERT_EQ(mesh.vertex_count(), 8U);
    ASSERT_EQ(mesh.triangle_count(), 4U);
    // The last node comes first: it mirrors, so w and the winding are flipped; it still faces +z.
    EXPECT_LT(glm::length(mesh.positions[2] - glm::vec3(9, 1, 3)), 1e-6);
    EXPECT_LT(glm::length(mesh.normals[2] - glm::vec3(0, 0, 1)), 1e-6);
    EXPECT_LT(glm::length(mesh.tangents[2] - glm::vec4(-1, 0, 0, -1)), 1e-6);
    // Scaled by 2 along x, then a quarter turn, then moved.
    EXPECT_LT(glm::length(mesh.positions[6] - glm::vec3(9, 2, 0)), 1e-6);
    EXPECT_LT(glm::length(mesh.tangents[6] - glm::vec4(0, 1, 0, 1)), 1e-6);
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]];
        EXPECT_GT(glm::cross(mesh.positions[mesh.indices[i + 1]] - a,
                             mesh.positions[mesh.indices[i + 2]] - a)
                      .z,
                  0);
    }
}

TEST(Gltf, PutsPrimitivesOfDifferentAttributesTogether) {
    GltfText gltf = square();
    gltf.add({1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}, "VEC3");
    gltf.primitive += R"(}, {"attributes": {"POSITION": 0, "COLOR_0": 3}, "indices": 2)";
    const Mesh mesh = mesh_of(gltf);
    ASSERT_EQ(mesh.vertex_count(), 8U);
    EXPECT_EQ(mesh.indices[6], 4U);
    EXPECT_EQ(mesh.colors[0], glm::vec4(1));
    EXPECT_EQ(mesh.colors[4], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(mesh.uvs[0][4], glm::vec2(0));
    EXPECT_EQ(mesh.tangents[0], glm::vec4(1, 0, 0, 1));
    EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[5])), 1, 1e-6);
}

class GltfFiles : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder / "models"); }

    void put(const std::string& name, const std::string& bytes) const {
        temporary.put(name, bytes);
    }

    std::string outcome(const std::string& uri, const fs::path& root = "") const {
        put("models/mesh.gltf", square().json(R"({"byteLength": 92, "uri": ")" + uri + "\"}"));
        Diagnostics diagnostics;
        MeshFileOptions options;
        options.root = root;
        const auto mesh = load_mesh(folder / "models/mesh.gltf", options, diagnostics);
        EXPECT_EQ(mesh.has_value(), !diagnostics.has_errors());
        return mesh ? "fine" : to_text(diagnostics);
    }

    TemporaryFolder temporary;
    fs::path folder = temporary.path();
};

TEST_F(GltfFiles, StandBelowTheFolderOrTheRoot) {
    put("far.bin", square().buffer());
    put("models/near.bin", square().buffer());
    fs::create_directory_symlink(folder, folder / "models/link");
    EXPECT_EQ(outcome("near.bin"), "fine");
    EXPECT_EQ(outcome("./near.bin"), "fine");
    EXPECT_EQ(outcome("../far.bin", folder), "fine");
    for (const std::string uri : {"../far.bin", "link/far.bin", "%2E%2E/far.bin"}) {
        const std::string said = outcome(uri);
        EXPECT_NE(said.find("outside its folder"), std::string::npos) << uri << said;
        EXPECT_NE(said.find("mesh.gltf"), std::string::npos) << said;
    }
    EXPECT_NE(outcome("/etc/passwd").find("error"), std::string::npos);
    EXPECT_NE(outcome("missing.bin").find("missing.bin"), std::string::npos);
    EXPECT_NE(outcome("near.bin\\u0000.png").find("error"), std::string::npos);
}

}  // namespace
}  // namespace wrinkle::test

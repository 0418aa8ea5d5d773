// Tests with published models, skipped if absent; none is part of the project. The expected counts
// come from the text of the files, not from the reader.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>

#include "mesh/load.h"

namespace wrinkle {
namespace {

const std::filesystem::path data = WRINKLE_SOURCE_DIR "/../shared/data";

std::optional<Mesh> loaded(const std::filesystem::path& path) {
    Diagnostics diagnostics;
    auto mesh = load_mesh(path, {}, diagnostics);
    EXPECT_TRUE(mesh) << to_text(diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    return mesh;
}

void expect_frames(const Mesh& mesh) {
    ASSERT_EQ(mesh.tangents.size(), mesh.vertex_count());
    for (size_t v = 0; v < mesh.vertex_count(); ++v) {
        ASSERT_NEAR(glm::length(mesh.normals[v]), 1, 1e-4);
        ASSERT_NEAR(glm::length(glm::vec3(mesh.tangents[v])), 1, 1e-4);
        ASSERT_NEAR(glm::dot(glm::vec3(mesh.tangents[v]), mesh.normals[v]), 0, 1e-4);
    }
}

TEST(RealFiles, Spot) {
    const auto path = data / "spot_triangulated.obj";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
    size_t faces = 0;
    std::ifstream text(path);
    for (std::string line; std::getline(text, line);)
        faces += line.starts_with("f ") ? 1 : 0;
    const auto mesh = loaded(path);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->triangle_count(), faces);
    expect_frames(*mesh);
    size_t mirrored = 0;  // corners with w < 0, the sign of the uv area
    for (size_t i = 0; i < mesh->indices.size(); ++i) {
        const auto uv = [&](size_t k) {
            return glm::dvec2(mesh->uvs[0][mesh->indices[i - i % 3 + k]]);
        };
        const glm::dvec2 b = uv(1) - uv(0), c = uv(2) - uv(0);
        const float w = mesh->tangents[mesh->indices[i]].w;
        ASSERT_EQ(w, b.x * c.y - b.y * c.x > 0 ? 1 : -1) << i;
        mirrored += w < 0 ? 1 : 0;
    }
    EXPECT_GT(mirrored, 100U);
}

TEST(RealFiles, TeaSet) {
    const auto path = data / "tea_set_01/tea_set_01_1k.gltf";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
    const auto mesh = loaded(path);
    ASSERT_TRUE(mesh);
    EXPECT_GT(mesh->triangle_count(), 1000U);
    expect_frames(*mesh);
    size_t outwards = 0;
    for (size_t i = 0; i < mesh->indices.size(); i += 3) {
        const auto at = [&](size_t k) { return glm::dvec3(mesh->positions[mesh->indices[k]]); };
        const glm::dvec3 a = at(i);
        const glm::dvec3 face = glm::cross(at(i + 1) - a, at(i + 2) - a);
        outwards += glm::dot(face, glm::dvec3(mesh->normals[mesh->indices[i]])) >= 0 ? 1 : 0;
    }
    EXPECT_GT(outwards, mesh->triangle_count() * 99 / 100);
}

}  // namespace
}  // namespace wrinkle

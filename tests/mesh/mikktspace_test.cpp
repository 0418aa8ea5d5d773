// Tests of tangents against other implementations: recorded results of the npm package mikktspace
// 1.1.1 (see oracle/record_mikktspace.js), and the tangents in a published glTF test file.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "base/file.h"
#include "json/parse.h"
#include "mesh/load.h"
#include "mesh/vertex_frames.h"

namespace wrinkle {
namespace {

struct Recorded {
    std::string name;
    Mesh mesh;
    std::vector<glm::vec4> corners;  // a tangent per index
};

template <size_t N>
std::array<float, N> numbers(const json::Value& row) {
    std::array<float, N> result{};
    size_t k = 0;
    for (const json::Member& member : row.children())
        result.at(k++) = static_cast<float>(member.value.as_number());
    return result;
}

std::vector<Recorded> recorded() {
    std::string why;
    const auto text = read_file(WRINKLE_SOURCE_DIR "/tests/mesh/oracle/mikktspace.json", why);
    Diagnostics diagnostics;
    const json::Parsed parsed = json::parse(text.value_or(""), "mikktspace.json", diagnostics);
    std::vector<Recorded> result;
    for (const json::Member& entry : parsed.root.find("meshes").children()) {
        Recorded& each = result.emplace_back();
        each.name = entry.value.find("name").as_string();
        for (const json::Member& row : entry.value.find("vertices").children()) {
            const auto v = numbers<8>(row.value);
            each.mesh.positions.emplace_back(v[0], v[1], v[2]);
            each.mesh.normals.emplace_back(v[3], v[4], v[5]);
            each.mesh.uvs[0].emplace_back(v[6], v[7]);
        }
        for (const json::Member& index : entry.value.find("indices").children())
            each.mesh.indices.push_back(static_cast<uint32_t>(index.value.as_number()));
        for (const json::Member& row : entry.value.find("tangents").children()) {
            const auto t = numbers<4>(row.value);
            each.corners.emplace_back(t[0], t[1], t[2], t[3]);
        }
    }
    return result;
}

// The reference returns (1, 0, 0) for a tangent without a direction; make_tangents() differs there.
bool is_placeholder(const std::string& mesh, glm::vec4 tangent) {
    return mesh == "degenerate" && glm::vec3(tangent) == glm::vec3(1, 0, 0);
}

TEST(MikkTSpace, AgreesWithRecordedTangents) {
    const auto all = recorded();
    ASSERT_EQ(all.size(), 6U);
    for (const Recorded& each : all) {
        Mesh mesh = each.mesh;
        ASSERT_TRUE(make_tangents(mesh));
        ASSERT_EQ(mesh.indices.size(), each.corners.size());
        size_t compared = 0;
        for (size_t i = 0; i < each.corners.size(); ++i) {
            const glm::vec4 tangent = mesh.tangents[mesh.indices[i]];
            const glm::vec4 expected = each.corners[i];
            EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1, 1e-6);
            if (is_placeholder(each.name, expected)) continue;
            ++compared;
            EXPECT_LT(glm::length(tangent - expected), 2e-5)
                << each.name << " corner " << i << ": " << tangent.x << " " << tangent.y << " "
                << tangent.z << " " << tangent.w << ", not " << expected.x << " " << expected.y
                << " " << expected.z << " " << expected.w;
        }
        EXPECT_GT(compared, each.corners.size() / 2) << each.name;
    }
}

// Quads of every direction and mirroring with TANGENT attributes. The project may not redistribute
// it.
TEST(MikkTSpace, AgreesWithTheTangentMirrorTest) {
    const std::filesystem::path path =
        WRINKLE_SOURCE_DIR "/../shared/data/NormalTangentMirrorTest.glb";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
    Diagnostics diagnostics;
    auto mesh = load_mesh(path, {}, diagnostics);
    ASSERT_TRUE(mesh) << to_text(diagnostics);
    const Mesh given = *mesh;
    ASSERT_TRUE(make_tangents(*mesh));
    size_t mirrored = 0, near = 0;
    for (size_t i = 0; i < given.indices.size(); ++i) {
        const glm::vec4 expected = given.tangents[given.indices[i]];
        const glm::vec4 tangent = mesh->tangents[mesh->indices[i]];
        ASSERT_EQ(tangent.w, expected.w) << "corner " << i;
        mirrored += expected.w < 0 ? 1 : 0;
        near += glm::length(glm::vec3(tangent - expected)) < 0.01 ? 1 : 0;
    }
    EXPECT_GT(mirrored, 100U);
    EXPECT_GT(near, given.indices.size() * 99 / 100);
}

}  // namespace
}  // namespace wrinkle

// Tests that the meshes of graphs/compare are those that their generator writes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>

#include "base/file.h"
#include "mesh/load.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

const fs::path committed = WRINKLE_SOURCE_DIR "/graphs/compare/meshes/bent_cylinder.glb";

TEST(MadeFiles, RemadeMeshesAreTheCommittedOnes) {
    const fs::path folder = fs::temp_directory_path() / ("wrinkle-" + std::to_string(getpid()));
    fs::create_directories(folder);
    const std::string command = MAKE_MESHES " " + folder.string();
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::string why;
    const auto made = read_file(folder / committed.filename(), why);
    const auto kept = read_file(committed, why);
    fs::remove_all(folder);
    ASSERT_TRUE(made && kept) << why;
    EXPECT_TRUE(*made == *kept);
}

// The skinned normals and tangents fit the triangles of the pose, as closely as blended matrices
// allow; less so inside the bend, where the tube is compressed.
TEST(MadeFiles, TheBentCylinderIsASmoothTubeWithTangentsAlongItsUv) {
    Diagnostics diagnostics;
    const auto mesh = load_mesh(committed, {}, diagnostics);
    ASSERT_TRUE(mesh) << to_text(diagnostics);
    ASSERT_EQ(mesh->tangents.size(), mesh->vertex_count());
    for (size_t i = 0; i < mesh->indices.size(); i += 3) {
        const auto* corner = &mesh->indices[i];
        const auto edge = [&](int k) {
            return mesh->positions[corner[k]] - mesh->positions[corner[0]];
        };
        const auto turn = [&](int k) { return mesh->uvs[0][corner[k]] - mesh->uvs[0][corner[0]]; };
        const glm::vec3 face = glm::normalize(glm::cross(edge(1), edge(2)));
        ASSERT_GT(glm::dot(face, mesh->normals[corner[0]]), 0.5F);
        const float det = turn(1).x * turn(2).y - turn(2).x * turn(1).y;
        ASSERT_GT(det, 0) << "v is turned over";
        const glm::vec3 along_u = (edge(1) * turn(2).y - edge(2) * turn(1).y) / det;
        const glm::vec4 tangent = mesh->tangents[corner[0]];
        ASSERT_GT(glm::dot(glm::normalize(along_u), glm::vec3(tangent)), 0.9F);
        ASSERT_EQ(tangent.w, 1);
    }
}

}  // namespace
}  // namespace wrinkle

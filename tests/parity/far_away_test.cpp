// T14: tests on the GPU that an object moved by its matrix to a distance of ten kilometres, with
// the camera moved alike, has the same normals in every pixel as at the origin; and that an object
// rotated together with the camera does too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "emit/emit.h"
#include "gpu/renderer.h"
#include "mesh/shapes.h"
#include "parity/context.h"
#include "parity/node_graph.h"

namespace wrinkle::test {
namespace {

constexpr int far_side = 96;

Shader material_of(const std::filesystem::path& path) {
    Diagnostics diagnostics;
    const Project project = load_project(path, {}, diagnostics);
    MaterialOptions options;
    options.vertex_tangents = false;
    const Compiled compiled = compile_material(project, all_nodes(), options, diagnostics);
    EXPECT_TRUE(compiled.ok) << to_text(diagnostics);
    return emit(compiled.module, {});
}

std::vector<float> normals(gpu::Renderer& renderer, const gpu::Scene& scene) {
    Diagnostics diagnostics;
    const auto target =
        gpu::Target::make({far_side, far_side, gpu::PixelFormat::rgba32f}, diagnostics);
    gpu::ViewOptions options;
    options.view = gpu::View::normal;
    options.raw = true;
    EXPECT_TRUE(target && renderer.draw(scene, options, *target, diagnostics))
        << to_text(diagnostics);
    return target->read();
}

struct Difference {
    double mean = 0;    // degrees
    size_t pixels = 0;  // covered in both
    size_t edges = 0;   // covered in only one
};

Difference difference(const std::vector<float>& a, const std::vector<float>& b) {
    Difference result;
    for (size_t i = 0; i < a.size(); i += 4) {
        const bool in_a = a[i + 3] > 0, in_b = b[i + 3] > 0;
        result.edges += in_a != in_b ? 1 : 0;
        if (!in_a || !in_b) continue;
        const glm::dvec3 n(a[i], a[i + 1], a[i + 2]), m(b[i], b[i + 1], b[i + 2]);
        EXPECT_NEAR(glm::length(m), 1, 1e-4);
        result.mean += std::atan2(glm::length(glm::cross(n, m)), glm::dot(n, m));
        ++result.pixels;
    }
    result.mean *= 180 / std::numbers::pi / static_cast<double>(std::max<size_t>(result.pixels, 1));
    return result;
}

// Compares the normals at the origin and after `change`, on graphs of both kinds: uvs of the mesh,
// and noise in space.
template <class Change>
void expect_unchanged(const Change& change) {
    const Mesh mesh = *make_shape("sphere");
    for (const char* graph : {"noise_rock.json", "woven_strap.json"}) {
        SCOPED_TRACE(graph);
        gpu::Renderer renderer;
        renderer.set_mesh(mesh);
        Diagnostics diagnostics;
        const std::filesystem::path path = WRINKLE_SOURCE_DIR "/graphs";
        ASSERT_TRUE(renderer.set_material(material_of(path / graph), diagnostics))
            << to_text(diagnostics);
        gpu::Scene scene;
        scene.camera = gpu::default_camera(mesh, "sphere");
        const std::vector<float> before = normals(renderer, scene);
        change(scene);
        const Difference changed = difference(before, normals(renderer, scene));
        EXPECT_GT(changed.pixels, size_t{far_side * far_side / 3});
        EXPECT_LE(changed.edges, 8U);
        EXPECT_LE(changed.mean, 0.05);
    }
}

using FarAway = WithGpu;

TEST_F(FarAway, T14_AnObjectTenKilometresAwayLooksTheSame) {
    expect_unchanged([](gpu::Scene& scene) {
        const glm::vec3 away(7000, -5000, 5099);
        scene.object = glm::translate(glm::mat4(1), away);
        scene.camera.target += away;
    });
}

// A bump computed in object space rotates with the object.
TEST_F(FarAway, Pitfall25ABumpTurnsWithItsObject) {
    expect_unchanged([](gpu::Scene& scene) {
        scene.object = glm::rotate(glm::mat4(1), 0.8F, glm::vec3(0, 1, 0));
        scene.camera.yaw += 0.8F;
    });
}

}  // namespace
}  // namespace wrinkle::test

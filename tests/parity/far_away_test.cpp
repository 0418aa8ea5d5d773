// T14 on the GPU: an object that its matrix puts ten kilometres away, seen by a camera that went
// with it, has the same normals in every pixel as at the origin.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "glsl/emit.h"
#include "gpu/from_glsl.h"
#include "gpu/renderer.h"
#include "mesh/shapes.h"
#include "parity/context.h"
#include "parity/node_graph.h"
#include "parity/samples.h"

namespace wrinkle::test {
namespace {

constexpr int side = 96;

gpu::Material material_of(const std::filesystem::path& path, bool vertex_tangents) {
    Diagnostics diagnostics;
    const Project project = load_project(path, {}, diagnostics);
    MaterialOptions options;
    options.vertex_tangents = vertex_tangents;
    const Compiled compiled = compile_material(project, all_nodes(), options, diagnostics);
    EXPECT_TRUE(compiled.ok) << to_text(diagnostics);
    return gpu::material_from(emit(compiled.module, {}));
}

std::vector<float> normals(gpu::Renderer& renderer, const gpu::Scene& scene) {
    Diagnostics diagnostics;
    const auto target = gpu::Target::make({side, side, gpu::PixelFormat::rgba32f}, diagnostics);
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
    size_t edges = 0;   // in one alone
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

using FarAway = WithGpu;

TEST_F(FarAway, T14_AnObjectTenKilometresAwayLooksTheSame) {
    const Mesh mesh = *make_shape("sphere");
    for (const std::filesystem::path& path : sample_graphs()) {
        if (!std::string(path).ends_with("noise_rock.json") &&
            !std::string(path).ends_with("woven_strap.json"))
            continue;
        SCOPED_TRACE(path.string());
        gpu::Renderer renderer;
        renderer.set_mesh(mesh);
        Diagnostics diagnostics;
        ASSERT_TRUE(renderer.set_material(material_of(path, false), diagnostics))
            << to_text(diagnostics);
        gpu::Scene scene;
        scene.camera = gpu::default_camera(mesh, "sphere");
        const std::vector<float> here = normals(renderer, scene);
        const glm::vec3 away(7000, -5000, 5099);
        scene.object = glm::translate(glm::mat4(1), away);
        scene.camera.target += away;
        const Difference moved = difference(here, normals(renderer, scene));
        EXPECT_GT(moved.pixels, size_t{side * side / 3});
        EXPECT_LE(moved.edges, 8U);
        EXPECT_LE(moved.mean, 0.05);
    }
}

}  // namespace
}  // namespace wrinkle::test

// Tests of close-ups on the GPU, with dFdx of the GPU's own interpolants: a wave of known slope on
// a plane, with pixels from a hundredth of the uv square to a millionth.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "emit/emit.h"
#include "gpu/renderer.h"
#include "mesh/shapes.h"
#include "parity/context.h"
#include "parity/node_graph.h"

namespace wrinkle::test {
namespace {

constexpr int side = 32;

// h = 0.02 sin(20 u) over the uv of a plane with sides of length 2.
const char* const wave = R"({"wrinkle": 1, "nodes": {
    "uv": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
    "k": {"type": "multiply", "in": {"a": {"from": "uv.x"}, "b": 20}},
    "s": {"type": "sine", "in": {"angle": {"from": "k.result"}}},
    "h": {"type": "height_scale", "in": {"height": {"from": "s.result"}, "amount": 0.02}},
    "r": {"type": "resolve", "in": {"gradient": {"from": "h.height"}}}
  }, "outputs": {"normal": {"from": "r.normal"}}})";

Shader material() {
    Diagnostics diagnostics;
    const Project project =
        load_project(read_document(wave, "wave.json", diagnostics), {}, {}, diagnostics);
    const Compiled compiled = compile_material(project, all_nodes(), {}, diagnostics);
    EXPECT_TRUE(compiled.ok) << to_text(diagnostics);
    return emit(compiled.module, {});
}

std::vector<float> draw(gpu::Renderer& renderer, const gpu::Scene& scene, gpu::View view) {
    Diagnostics diagnostics;
    const auto target = gpu::Target::make({side, side, gpu::PixelFormat::rgba32f}, diagnostics);
    gpu::ViewOptions options;
    options.view = view;
    options.raw = true;
    EXPECT_TRUE(target && renderer.draw(scene, options, *target, diagnostics))
        << to_text(diagnostics);
    return target->read();
}

using CloseUp = WithGpu;

TEST_F(CloseUp, KeepsTheBumpDownToAMillionthOfTheUv) {
    const Mesh plane = *make_shape("plane");
    gpu::Renderer renderer;
    renderer.set_mesh(plane);
    Diagnostics diagnostics;
    ASSERT_TRUE(renderer.set_material(material(), diagnostics)) << to_text(diagnostics);
    for (const double pixel : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        gpu::Scene scene;
        scene.camera = gpu::default_camera(plane, "plane");
        scene.camera.target = {-0.37F, 0.21F, 0};
        scene.camera.distance =
            static_cast<float>(pixel * side / std::tan(scene.camera.field_of_view / 2));
        const std::vector<float> normals = draw(renderer, scene, gpu::View::normal);
        const std::vector<float> uvs = draw(renderer, scene, gpu::View::uv);
        EXPECT_NEAR(uvs[4] - uvs[0], pixel, 0.1 * pixel) << "not that close";
        double worst = 0;
        for (size_t i = 0; i < normals.size(); i += 4) {
            if (normals[i + 3] == 0) continue;
            const double slope = 0.02 * 20 * std::cos(20.0 * uvs[i]) / 2;
            const glm::dvec3 expected = glm::normalize(glm::dvec3(-slope, 0, 1));
            const glm::dvec3 got(normals[i], normals[i + 1], normals[i + 2]);
            worst = std::fmax(
                worst, std::atan2(glm::length(glm::cross(got, expected)), glm::dot(got, expected)));
        }
        worst *= 180 / std::numbers::pi;
        EXPECT_LE(worst, pixel >= 1e-5 ? 0.1 : 1.5) << pixel;
    }
}

}  // namespace
}  // namespace wrinkle::test

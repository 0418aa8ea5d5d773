// Fixtures of the tests of energy: materials of constants in an environment of radiance 1, or under
// one directional light.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/standard_outputs.h"
#include "fixture.h"

namespace wrinkle::gpu {

// Numbers of standard outputs; a color is gray.
using Values = std::vector<std::pair<std::string, double>>;

inline const std::vector<std::string> plain_inputs = {
    "color",           "metalness",    "roughness",  "occlusion", "base_diffuse_roughness",
    "specular_weight", "specular_ior", "base_weight"};
inline const std::vector<std::string> layered_inputs = {
    "specular_color",   "specular_roughness_anisotropy",
    "coat_weight",      "coat_color",
    "coat_roughness",   "coat_ior",
    "coat_darkening",   "fuzz_color",
    "fuzz_weight",      "fuzz_roughness",
    "subsurface_color", "subsurface_weight"};

// A material of uniforms. All that need the layered model differ by their uniforms only, and so do
// the others: a draw compiles nothing.
inline Shader constant_material(const Values& values) {
    std::vector<std::string> names = plain_inputs;
    const bool layered = std::any_of(values.begin(), values.end(), [](const auto& value) {
        return std::ranges::find(layered_inputs, value.first) != layered_inputs.end();
    });
    if (layered) names.insert(names.end(), layered_inputs.begin(), layered_inputs.end());
    std::vector<Expression> outputs;
    std::vector<UniformInfo> uniforms;
    std::string globals;
    for (const std::string& name : names) {
        const StandardOutput& output = *find_standard_output(name);
        const bool color = output.type == "color";
        const std::string uniform = "u_" + name;
        globals += "uniform float " + uniform + ";\n";
        outputs.push_back(
            {name, color ? "vec3(" + uniform + ")" : uniform, color ? Type::vec3_ : Type::float_});
        double number = output.value[0];
        for (const auto& [given, value] : values)
            if (given == name) number = value;
        uniforms.push_back(uniform_info(uniform, Type::float_, {number}));
    }
    Shader material = material_of(outputs, {}, globals);
    material.reflection.uniforms = uniforms;
    return material;
}

class FurnaceTest : public WithRenderer {
protected:
    void SetUp() override {
        WithRenderer::SetUp();
        renderer->set_mood(Mood::furnace);
        show("sphere");
    }

    // Returns the lowest and highest radiance of the sphere.
    std::pair<float, float> extremes(const Values& values) {
        float low = 1e9F, high = 0;
        for (const Pixel& pixel : draw(constant_material(values), View::shaded)) {
            if (!pixel.covered) continue;
            for (int k = 0; k < 3; ++k) {
                low = std::min(low, pixel.value[k]);
                high = std::max(high, pixel.value[k]);
            }
        }
        return {low, high};
    }
};

// Draws one pixel of a plane. Light and eye are in its frame, z its normal.
class LobeTest : public FurnaceTest {
protected:
    void SetUp() override {
        FurnaceTest::SetUp();
        target = Target::make({1, 1, PixelFormat::rgba32f}, diagnostics);
        ASSERT_TRUE(target) << errors();
    }
    double seen_from(glm::dvec3 eye) {
        scene.camera.yaw = static_cast<float>(std::atan2(eye.x, eye.z));
        scene.camera.pitch = static_cast<float>(std::asin(eye.y));
        return static_cast<double>(draw(View::shaded)[0].value.g);
    }
    double lit(glm::dvec3 light, glm::dvec3 eye) {
        scene.light = 1;
        scene.environment = 0;
        scene.to_light = light;
        return seen_from(eye);
    }
    double in_environment(glm::dvec3 eye) {
        scene.light = 0;
        scene.environment = 1;
        return seen_from(eye);
    }
    void use(const Values& values) {
        show("plane");
        scene.camera.distance *= 40;  // rays are parallel
        scene.camera.field_of_view /= 40;
        ASSERT_TRUE(renderer->set_material(constant_material(values), diagnostics)) << errors();
    }
};

}  // namespace wrinkle::gpu

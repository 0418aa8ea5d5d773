// Fixture of the tests of core/gpu: a current GL context, and small hand-written materials.
#pragma once

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "glsl/attributes.h"
#include "glsl/emit.h"
#include "gpu/context.h"
#include "gpu/renderer.h"
#include "mesh/shapes.h"

namespace wrinkle::gpu {

class WithContext : public testing::Test {
protected:
    void SetUp() override {
        context = Context::offscreen(diagnostics);
        ASSERT_TRUE(context) << to_text(diagnostics);
        ASSERT_TRUE(context->make_current());
    }

    std::string errors() const { return to_text(diagnostics); }

    Diagnostics diagnostics;
    std::optional<Context> context;
};

inline FunctionInfo function_info(const std::string& output, const std::string& function,
                                  Type type) {
    FunctionInfo result;
    result.output = output;
    result.function = function;
    result.type = type;
    return result;
}

inline UniformInfo uniform_info(const std::string& name, Type type,
                                const std::array<double, 4>& value) {
    UniformInfo result;
    result.name = name;
    result.type = type;
    result.value = value;
    return result;
}

inline SamplerInfo sampler_info(const std::string& name, const std::string& file,
                                const TextureOptions& options = {}) {
    SamplerInfo result;
    result.name = name;
    result.file = file;
    result.options = options;
    return result;
}

// A material with the normal output `expression` over the members of `s`.
inline Shader material_with_normal(const std::string& expression,
                                   const std::vector<MemberInfo>& members) {
    Shader material;
    material.reflection.struct_name = "WrinkleSurface_test";
    material.reflection.members = members;
    material.source = "struct WrinkleSurface_test {\n";
    for (const MemberInfo& member : members)
        material.source += "    " + std::string(info(member.type).name) + " " + member.name + ";\n";
    material.source += "};\nvec3 wrinkle_test_normal(WrinkleSurface_test s) {\n    return " +
                       expression + ";\n}\n";
    material.reflection.functions = {function_info("normal", "wrinkle_test_normal", Type::vec3_)};
    return material;
}

// Returns true if `message` contains `words`. A line number of a compile log in Mesa's form,
// ":12(", also matches "(12)" of other drivers.
inline bool mentions(const std::string& message, std::string words) {
    if (message.find(words) != std::string::npos) return true;
    if (words.front() != ':' || words.back() != '(') return false;
    words = "(" + words.substr(1, words.size() - 2) + ")";
    return message.find(words) != std::string::npos;
}

struct Pixel {
    glm::vec3 value;
    bool covered;
};

// Draws one view of a shape and reads it back unchanged.
class WithRenderer : public WithContext {
protected:
    static constexpr int size = 64;

    void SetUp() override {
        WithContext::SetUp();
        target = Target::make({size, size, PixelFormat::rgba32f}, diagnostics);
        ASSERT_TRUE(target) << errors();
        renderer.emplace();
        show("sphere");
    }

    void TearDown() override {
        renderer.reset();
        target.reset();
    }

    void show(const std::string& shape) {
        const Mesh mesh = *make_shape(shape);
        renderer->set_mesh(mesh);
        scene.camera = default_camera(mesh, shape);
    }

    std::vector<Pixel> draw(View view, const std::string& against = "") {
        ViewOptions options;
        options.view = view;
        options.against = against;
        options.raw = true;
        EXPECT_TRUE(renderer->draw(scene, options, *target, diagnostics)) << errors();
        std::vector<Pixel> pixels;
        const std::vector<float> floats = target->read();
        for (size_t i = 0; i < floats.size(); i += 4)
            pixels.push_back({{floats[i], floats[i + 1], floats[i + 2]}, floats[i + 3] > 0});
        return pixels;
    }

    std::vector<Pixel> draw(const Shader& material, View view) {
        EXPECT_TRUE(renderer->set_material(material, diagnostics)) << errors();
        return draw(view);
    }

    std::optional<Target> target;
    std::optional<Renderer> renderer;
    Scene scene;
};

inline size_t covered(const std::vector<Pixel>& pixels) {
    size_t count = 0;
    for (const Pixel& pixel : pixels)
        count += pixel.covered ? 1 : 0;
    return count;
}

// A bump with a gradient of length 0.3 everywhere, with outputs `flat` and `height` = 7 n.y.
inline Shader tilted() {
    Shader material = material_with_normal(
        "normalize(normalize(s.normal) - 0.3 * normalize(cross(s.normal, vec3(0.0, 1.0, 0.0))))",
        {{"normal", Type::vec3_, SurfaceInput::normal_}});
    material.source +=
        "vec3 wrinkle_test_flat(WrinkleSurface_test s) { return normalize(s.normal); }\n"
        "float wrinkle_test_height(WrinkleSurface_test s) { return 7.0 * s.normal.y; }\n";
    material.reflection.functions.push_back(
        function_info("flat", "wrinkle_test_flat", Type::vec3_));
    material.reflection.functions.push_back(
        function_info("height", "wrinkle_test_height", Type::float_));
    return material;
}

}  // namespace wrinkle::gpu

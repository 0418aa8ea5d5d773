// Fixture of the tests of core/gpu: a current GL context, and small hand-written materials.
#pragma once

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "emit/attributes.h"
#include "emit/emit.h"
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

// An output and its expression over the members of `s`.
struct Expression {
    std::string output, text;
    Type type = Type::vec3_;
};

// A material of expressions; without members its function takes no argument. `globals` are declared
// before it.
inline Shader material_of(const std::vector<Expression>& expressions,
                          const std::vector<MemberInfo>& members, const std::string& globals = "") {
    Shader material;
    Reflection& r = material.reflection;
    r.function = "wrinkle_test";
    r.result_name = "WrinkleMaterial_test";
    r.members = members;
    material.source = globals;
    const auto declare = [&](const std::string& name, const auto& fields, auto name_of) {
        material.source += "struct " + name + " {\n";
        for (const auto& field : fields)
            material.source +=
                "    " + std::string(info(field.type).name) + " " + name_of(field) + ";\n";
        material.source += "};\n";
    };
    if (!members.empty()) r.struct_name = "WrinkleSurface_test";
    if (!members.empty())
        declare(r.struct_name, members, [](const MemberInfo& each) { return each.name; });
    declare(r.result_name, expressions, [](const Expression& each) { return each.output; });
    material.source += r.result_name + " wrinkle_test(" +
                       (members.empty() ? "" : r.struct_name + " s") + ") {\n    " + r.result_name +
                       " m;\n";
    for (const Expression& each : expressions) {
        material.source += "    m." + each.output + " = " + each.text + ";\n";
        OutputInfo& output = r.outputs.emplace_back();
        output.output = output.member = each.output;
        output.type = each.type;
    }
    material.source += "    return m;\n}\n";
    return material;
}

inline Shader material_with_normal(const std::string& expression,
                                   const std::vector<MemberInfo>& members) {
    return material_of({{"normal", expression}}, members);
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

// A bump with a gradient of length 0.3 everywhere, with outputs `unbumped` and `height`.
inline Shader tilted(const std::string& height = "7.0 * s.normal.y") {
    return material_of({{"normal",
                         "normalize(normalize(s.normal) - 0.3 * normalize(cross(s.normal, "
                         "vec3(0.0, 1.0, 0.0))))"},
                        {"unbumped", "normalize(s.normal)"},
                        {"height", height, Type::float_}},
                       {{"normal", Type::vec3_, SurfaceInput::normal_}});
}

}  // namespace wrinkle::gpu

// Tests of constants that have a name: a declaration with a comment, once, in every language.
#include <gtest/gtest.h>

#include "emit/emit.h"
#include "glslang/validate.h"
#include "graphs.h"

namespace wrinkle::test {
namespace {

size_t count_of(const std::string& text, const std::string& part) {
    size_t found = 0;
    for (size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

// Two nodes add the same named constant, and a vector of constants is multiplied.
Module two_readers() {
    Module m;
    const Value x{&m, m.swizzle(m.input(SurfaceInput::uv0_), "x")};
    node(m, "a", "First");
    const Value first = x + constant("golden // the golden ratio", x, 1.618034);
    node(m, "b", "Second");
    const Value second = first * first + constant("golden // another comment", x, 1.618034);
    const std::array<double, 3> lanes{0.2126, 0.7152, 0.0722};
    const Value weights =
        named("weights // of Rec. 709", Value{&m, m.constant(Type::vec3_, lanes)});
    output(m, "roughness", second.id);
    output(m, "color", (weights * second).id, WR_PORT_color);
    return m;
}

std::string text_in(const char* target, const Module& module) {
    EmitOptions options;
    options.name = "gold";
    options.target = find_target(target);
    const Shader shader = emit(module, options);
    if (has_validator(*options.target)) {
        EXPECT_EQ(compile_errors(shader), "") << target;
    }
    return shader.source;
}

TEST(Constants, AreDeclaredOnceWithTheirComment) {
    const Module module = two_readers();
    for (const auto& [target, number, vector] :
         {std::tuple("glsl330", "const float gold_golden = 1.618034;",
                     "const vec3 gold_weights = vec3(0.2126, 0.7152, 0.0722);"),
          std::tuple("hlsl", "static const float gold_golden = 1.618034;",
                     "static const float3 gold_weights = float3(0.2126, 0.7152, 0.0722);"),
          std::tuple("msl", "constant float gold_golden = 1.618034;",
                     "constant float3 gold_weights = float3(0.2126, 0.7152, 0.0722);"),
          std::tuple("wgsl", "const gold_golden: f32 = 1.618034;",
                     "const gold_weights: vec3f = vec3f(0.2126, 0.7152, 0.0722);"),
          std::tuple("godot3", "const float gold_golden = 1.618034;",
                     "const vec3 gold_weights = vec3(0.2126, 0.7152, 0.0722);")}) {
        const std::string text = text_in(target, module);
        EXPECT_EQ(count_of(text, number), 1U) << text;
        EXPECT_EQ(count_of(text, vector), 1U) << text;
        EXPECT_EQ(count_of(text, "// the golden ratio"), 1U) << text;
        EXPECT_EQ(count_of(text, "another comment"), 0U) << text;
        EXPECT_EQ(count_of(text, "1.618034"), 1U) << text;
        EXPECT_EQ(count_of(text, "0.7152"), 1U) << text;
        EXPECT_EQ(count_of(text, "gold_golden"), 3U) << text;
    }
}

TEST(Constants, AreNotDeclaredIfShortOrUnusedOrNoNumbers) {
    Module m;
    const Value x{&m, m.swizzle(m.input(SurfaceInput::uv0_), "x")};
    constant("unused // in no output", x, 3.25);
    named("sum // of no constants", x + x);
    output(m, "roughness", (x + constant("half // short", x, 0.5)).id);
    const std::string text = text_in("glsl330", m);
    EXPECT_EQ(count_of(text, "const "), 0U) << text;
    EXPECT_EQ(count_of(text, "+ 0.5"), 1U) << text;
}

TEST(Constants, HaveNoNameThatAnImageHas) {
    Module m;
    node(m, "golden", "Image");
    const Value texel{&m, image(m, "image", "a.png", m.input(SurfaceInput::uv0_))};
    output(m, "roughness",
           (texel.x() + constant("golden_image // of no image", texel, 1.618034)).id);
    const std::string text = text_in("glsl330", m);
    EXPECT_EQ(count_of(text, "uniform sampler2D gold_golden_image;"), 1U) << text;
    EXPECT_EQ(count_of(text, "const float gold_golden_image_2 = 1.618034;"), 1U) << text;
}

}  // namespace
}  // namespace wrinkle::test

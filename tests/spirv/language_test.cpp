// Tests of the contents of SPIR-V, HLSL, Metal and WGSL, and of their reflection.
#include <gtest/gtest.h>

#include <thread>

#include "base/text.h"
#include "emit/log.h"
#include "glslang/validate.h"
#include "ir/module.h"
#include "spirv/metal.h"
#include "spirv/spirv.h"

namespace wrinkle::test {
namespace {

// Two nodes: "weave" samples, "soft" is a number; normal and roughness.
Module sample() {
    Module m;
    m.nodes[0].title = m.titles.add("Weave");
    const auto node = [&](const char* path) {
        NodeInstance instance;
        instance.path = path;
        instance.title = m.titles.add("Node");
        m.nodes.push_back(instance);
        m.current_node = static_cast<uint32_t>(m.nodes.size() - 1);
    };
    node("weave");
    Resource resource;
    resource.file = resource.name = "weave.png";
    resource.readers = {{m.current_node, "image"}};
    const Id texel = m.add(Op::sample_, {m.input(SurfaceInput::uv0_)}, m.add_resource(resource));
    node("soft");
    Id value = m.swizzle(texel, "x");
    for (const Type type : {Type::float_, Type::vec3_, Type::vec2_, Type::float_}) {
        Parameter parameter;
        parameter.node = m.current_node;
        parameter.port = "p" + std::to_string(m.parameters.size());
        parameter.type = type;
        const Id number = m.parameter(m.add_parameter(parameter));
        value = m.add(Op::mul_, {m.add(Op::sin_, {value}),
                                 type == Type::float_ ? number : m.swizzle(number, "y")});
    }
    m.outputs.push_back({"roughness", WR_PORT_float, value});
    m.outputs.push_back({"normal", WR_PORT_normal, m.input(SurfaceInput::view_)});
    return m;
}

Shader written(const char* target) {
    EmitOptions options;
    options.target = find_target(target);
    options.form = Form::shader;
    options.name = "strap";
    return write_shader(sample(), options);
}

bool has(const std::string& text, const std::string& words) {
    return text.find(words) != text.npos;
}

TEST(Hlsl, StandsWhereTheReflectionSays) {
    const Shader shader = written("hlsl");
    ASSERT_TRUE(shader.problems.empty()) << shader.problems[0].message;
    EXPECT_EQ(hlsl_errors(shader.vertex, Stage::vertex), "");
    EXPECT_EQ(hlsl_errors(shader.fragment, Stage::fragment), "");
    const Reflection& r = shader.reflection;
    EXPECT_TRUE(has(shader.vertex, "cbuffer WrinkleFrame : register(b0)"));
    EXPECT_TRUE(has(shader.fragment, "cbuffer WrinkleParameters_strap : register(b1)"));
    EXPECT_TRUE(has(shader.fragment, r.samplers[0].name + " : register(t0)"));
    EXPECT_TRUE(has(shader.fragment, r.samplers[0].name + "_sampler : register(s0)"));
    EXPECT_TRUE(has(shader.vertex, "float2 uv0 : TEXCOORD0"));
    EXPECT_TRUE(has(shader.vertex, "float3 position : POSITION"));
    for (const UniformInfo& uniform : r.uniforms) {
        const std::string lane =
            uniform.offset % 16 == 0 ? "" : std::string(".") + "xyzw"[uniform.offset % 16 / 4];
        const std::string place = " : packoffset(c" + std::to_string(uniform.offset / 16) + lane;
        EXPECT_TRUE(has(shader.fragment, " " + uniform.name + place + ")")) << shader.fragment;
    }
    EXPECT_TRUE(has(to_json(r), "\"semantic\": \"TEXCOORD0\""));
    EXPECT_FALSE(has(to_json(r), "\"set\""));
}

TEST(Metal, StandsWhereTheReflectionSays) {
    const Shader shader = written("msl");
    ASSERT_TRUE(shader.problems.empty()) << shader.problems[0].message;
    EXPECT_EQ(metal_errors(shader), "");
    EXPECT_TRUE(has(shader.fragment, "fragment WrinkleTargets_strap strap_fragment("));
    EXPECT_TRUE(has(to_json(shader.reflection),
                    "{\"vertex\": \"strap_vertex\", \"fragment\": \"strap_fragment\"}"));
    EXPECT_TRUE(has(shader.fragment, "strap_parameters." + shader.reflection.uniforms[0].name));
    // float, vec3, vec2: a vec3 takes 16 bytes, as a vec2 after it shows.
    EXPECT_EQ(shader.reflection.uniforms[1].offset, 16);
    EXPECT_EQ(shader.reflection.uniforms[2].offset, 32);
}

TEST(Wgsl, StandsWhereTheReflectionSays) {
    const Shader shader = written("wgsl");
    ASSERT_TRUE(shader.problems.empty()) << shader.problems[0].message;
    EXPECT_TRUE(has(shader.vertex, "@group(0) @binding(0) var<uniform> wrinkle_frame: "));
    EXPECT_TRUE(has(shader.fragment, "@group(0) @binding(1) var<uniform> strap_parameters: "));
    const SamplerInfo& image = shader.reflection.samplers[0];
    EXPECT_TRUE(has(shader.fragment, "@binding(2) var " + image.name + ": texture_2d<f32>;"));
    EXPECT_TRUE(has(shader.fragment, "@binding(3) var " + image.name + "_sampler: sampler;"));
    EXPECT_TRUE(has(to_json(shader.reflection), "\"binding\": 2, \"sampler_binding\": 3"));
    EXPECT_TRUE(has(shader.fragment, "@fragment fn strap_fragment("));
}

TEST(Languages, LinesNameTheirNodesAndAreCommented) {
    for (const auto& [target, read] : {std::pair("hlsl", ".Sample("), std::pair("msl", ".sample("),
                                       std::pair("wgsl", "textureSample(")}) {
        const Shader shader = written(target);
        const Reflection& r = shader.reflection;
        const auto lines = split(shader.fragment, '\n');
        ASSERT_EQ(lines.size(), r.lines.size() + 1);
        size_t seen = 0, commented = 0;
        for (size_t i = 0; i + 1 < lines.size(); ++i) {
            const std::string line(lines[i]);
            if (has(line, "// soft: Node")) ++commented;
            if (!has(line, read)) continue;
            ++seen;
            ASSERT_NE(node_of_line(r, i + 1), no_node) << line;
            EXPECT_EQ(r.node_paths[node_of_line(r, i + 1)], "soft") << line;
        }
        EXPECT_EQ(seen, 1U) << shader.fragment;
        EXPECT_EQ(commented, 1U) << shader.fragment;
    }
}

// In Godot 3, which has no structs, the members and the results are parameters.
TEST(Languages, WithoutStructsTakeParameters) {
    EmitOptions options;
    options.target = find_target("godot3");
    options.name = "strap";
    const Shader shader = write_shader(sample(), options);
    ASSERT_TRUE(shader.problems.empty()) << shader.problems[0].message;
    EXPECT_TRUE(has(shader.source,
                    "void wrinkle_strap(vec2 uv0, vec3 view, out float "
                    "out_roughness,"))
        << shader.source;
    EXPECT_TRUE(has(shader.source, "out vec3 out_normal) {"));
    EXPECT_TRUE(has(shader.source, "    out_normal = view;"));
    EXPECT_FALSE(has(shader.source, "struct"));
    EXPECT_TRUE(has(to_json(shader.reflection), "\"result_form\": \"parameters\""));
}

TEST(Spirv, IsValidKeepsNamesAndHasNoLines) {
    const Shader shader = written("spirv");
    ASSERT_TRUE(shader.problems.empty()) << shader.problems[0].message;
    for (const std::string* bytes : {&shader.vertex, &shader.fragment}) {
        std::string log;
        EXPECT_TRUE(is_valid(words_of(*bytes), log)) << log;
        EXPECT_EQ(wrinkle::bytes_of(words_of(*bytes)), *bytes);
    }
    const std::string text = disassembly(shader.fragment);
    EXPECT_TRUE(has(text, "OpName %out_normal \"out_normal\"")) << text;
    EXPECT_TRUE(has(text, "OpMemberName %WrinkleParameters_strap 0 \"strap_soft_p0\"")) << text;
    EXPECT_FALSE(has(text, "OpLine"));
    EXPECT_TRUE(shader.reflection.lines.empty());
    EXPECT_TRUE(has(to_json(shader.reflection), "\"set\": 0, \"binding\": 2"));
}

TEST(Spirv, BadBytesAreNoneAndSayWhy) {
    std::string log;
    EXPECT_EQ(disassembly("abc"), "");
    EXPECT_EQ(disassembly(std::string(64, 'x')), "");
    EXPECT_FALSE(is_valid({1, 2, 3}, log));
    EXPECT_NE(log, "");
    EXPECT_FALSE(optimised({1, 2, 3}, Inlining::none, log));
}

// Compiler messages for a line are attributed to the node of that line.
TEST(Spirv, RefusedTextsNameTheLineAndTheNode) {
    std::string log;
    const char* text = "#version 450\nvoid main() {\n    float a = b;\n}\n";
    EXPECT_FALSE(compile_to_spirv(text, ShaderStage::fragment, Lines::forget, log));
    EXPECT_EQ(line_in(log), 3U) << log;
    Reflection reflection;
    reflection.lines = {no_node, no_node, 7, no_node};
    const Problem problem = problem_of_log("SPIR-V cannot be made", log, reflection);
    EXPECT_EQ(problem.node, 7U);
    EXPECT_TRUE(has(problem.message, "SPIR-V cannot be made: ERROR: 0:3: 'b'")) << problem.message;
    EXPECT_EQ(problem.message.find('\n'), std::string::npos);
    reflection.lines.clear();
    EXPECT_EQ(problem_of_log("", log, reflection).node, 0U);
}

TEST(Spirv, OptimisingWithAndWithoutInlining) {
    std::string log;
    const char* text =
        "#version 450\nlayout(location = 0) out float o;\nlayout(location = 0) in float i;\n"
        "float f(float x) { return x * x + 1.0; }\nvoid main() { o = f(i) + f(i * 2.0); }\n";
    const auto words = compile_to_spirv(text, ShaderStage::fragment, Lines::forget, log);
    ASSERT_TRUE(words) << log;
    const auto calls = [&](Inlining inlining) {
        const auto made = optimised(*words, inlining, log);
        return made && is_valid(*made, log)
                   ? has(disassembly(wrinkle::bytes_of(*made)), "OpFunctionCall")
                   : -1;
    };
    EXPECT_EQ(calls(Inlining::none), 1) << log;
    EXPECT_EQ(calls(Inlining::all), 0) << log;
}

TEST(Languages, BytesAreTheSameOnEveryThread) {
    for (const char* target : {"spirv", "hlsl", "msl", "wgsl"}) {
        const Shader first = written(target);
        std::vector<Shader> others(8);
        std::vector<std::thread> threads;
        for (Shader& other : others)
            threads.emplace_back([&other, target] { other = written(target); });
        for (std::thread& thread : threads)
            thread.join();
        for (const Shader& other : others) {
            EXPECT_EQ(other.vertex, first.vertex);
            EXPECT_EQ(other.fragment, first.fragment);
            EXPECT_EQ(to_json(other.reflection), to_json(first.reflection));
        }
    }
}

TEST(Spirv, HasNoFunctionForm) {
    EmitOptions options;
    options.target = find_target("spirv");
    const Shader shader = write_shader(sample(), options);
    ASSERT_EQ(shader.problems.size(), 1U);
    EXPECT_TRUE(has(shader.problems[0].expected, "shader"));
    EXPECT_EQ(shader.source + shader.vertex + shader.fragment, "");
}

}  // namespace
}  // namespace wrinkle::test

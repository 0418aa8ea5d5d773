#include <gtest/gtest.h>

#include <sstream>

#include "glslang/validate.h"
#include "golden.h"
#include "graphs.h"
#include "ir/expand.h"
#include "ir/rewrite.h"

namespace wrinkle::test {
namespace {

EmitOptions options(Form form = Form::function, Differentials d = Differentials::screen) {
    EmitOptions result;
    result.form = form;
    result.differentials = d;
    result.name = "strap";
    return result;
}

size_t occurrences(const std::string& text, const std::string& word) {
    size_t count = 0;
    for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++count;
    return count;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

TEST(Emit, function_form_of_base_and_detail) {
    const Module module = expand(base_and_detail(), {});
    const Shader baked = emit(expand(module, {.parameters = Parameters::baked}), options());
    EXPECT_EQ(compile_errors(baked), "");
    EXPECT_TRUE(equals_golden(baked.source, "base_and_detail.glsl"));
    const Shader uniform = emit(module, options());
    EXPECT_EQ(compile_errors(uniform), "");
    EXPECT_TRUE(equals_golden(uniform.source, "base_and_detail.uniform.glsl"));
    EXPECT_TRUE(equals_golden(to_json(uniform.reflection), "base_and_detail.reflection.json"));
    EXPECT_TRUE(uniform.vertex.empty() && uniform.fragment.empty());
}

TEST(Emit, one_uv_set_takes_at_most_29_lines) {
    const Module module = expand(base_and_detail(SurfaceInput::uv0_), {});
    EmitOptions bare = options();
    bare.bare_result = true;
    const Shader shader = emit(expand(module, {.parameters = Parameters::baked}), bare);
    EXPECT_EQ(compile_errors(shader), "");
    EXPECT_TRUE(equals_golden(shader.source, "base_and_detail.uv0.glsl"));
    EXPECT_LE(lines_of(shader.source).size(), 29u);
}

TEST(Emit, given_differentials_are_members) {
    const Module module = explicit_lod(expand(base_and_detail(), {}));
    const Shader shader =
        emit(expand(module, {.parameters = Parameters::baked}), options({}, Differentials::given));
    EXPECT_EQ(compile_errors(shader), "");
    EXPECT_TRUE(equals_golden(shader.source, "base_and_detail.given.glsl"));
    EXPECT_EQ(shader.source.find("dFdx"), std::string::npos);
    EXPECT_EQ(shader.source.find("texture("), std::string::npos);
    EXPECT_FALSE(shader.reflection.uniform_control_flow);
}

TEST(Emit, shader_form_is_complete) {
    const Module module = expand(base_and_detail(), {});
    const Shader shader = emit(module, options(Form::shader));
    EXPECT_EQ(compile_errors(shader), "");
    EXPECT_TRUE(equals_golden(shader.vertex, "base_and_detail.vert"));
    EXPECT_TRUE(equals_golden(shader.fragment, "base_and_detail.frag"));
    EXPECT_TRUE(shader.source.empty());
}

TEST(Emit, shader_form_of_every_standard_output) {
    Module m;
    const Id position = m.input(SurfaceInput::position_);
    output(m, "roughness", m.swizzle(position, "x"));
    output(m, "normal", m.input(SurfaceInput::view_), WR_PORT_normal);
    output(m, "color", m.swizzle(m.input(SurfaceInput::color0_), "xyz"), WR_PORT_color);
    output(m, "mine too", m.input(SurfaceInput::facing_));
    output(m, "uv", m.input(SurfaceInput::uv3_), WR_PORT_vec2);
    const Shader shader = emit(m, options(Form::shader));
    EXPECT_EQ(compile_errors(shader), "");
    EXPECT_NE(shader.fragment.find("layout(location = 2) out float out_roughness;"),
              std::string::npos);
    EXPECT_NE(shader.fragment.find("layout(location = 0) out vec3 out_normal;"), std::string::npos);
    EXPECT_NE(shader.fragment.find("layout(location = 3) out float out_mine_too;"),
              std::string::npos);
    EXPECT_NE(shader.fragment.find("layout(location = 4) out vec2 out_uv;"), std::string::npos);
    EXPECT_NE(shader.vertex.find("layout(location = 6) in vec2 uv3;"), std::string::npos);
    EXPECT_EQ(shader.vertex.find("tangent"), std::string::npos);
}

TEST(Emit, the_space_of_normals_is_not_that_of_tangents) {
    Module m;
    output(m, "normal", m.input(SurfaceInput::view_), WR_PORT_normal);
    output(m, "tangent", m.input(SurfaceInput::position_), WR_PORT_vec3);
    EmitOptions world = options();
    world.normal_space = NormalSpace::world;
    const std::string source = emit(m, world).source;
    EXPECT_NE(source.find("unit normal, world space"), std::string::npos);
    EXPECT_NE(source.find("stretched along it, object space"), std::string::npos);
}

TEST(Emit, nothing_is_declared_that_is_not_read) {
    const Module module = expand(base_and_detail(), {});
    const Shader shader = emit(module, options());
    for (const MemberInfo& member : shader.reflection.members)
        EXPECT_NE(shader.source.find("s." + member.name), std::string::npos) << member.name;
    for (const UniformInfo& uniform : shader.reflection.uniforms)
        EXPECT_GE(occurrences(shader.source, uniform.name), 2u) << uniform.name;
    for (const SamplerInfo& sampler : shader.reflection.samplers)
        EXPECT_GE(occurrences(shader.source, sampler.name), 2u) << sampler.name;
    const Shader form = emit(module, options(Form::shader));
    for (const std::string& varying : form.reflection.varyings) {
        EXPECT_GE(occurrences(form.fragment, varying), 2u) << varying;
        EXPECT_GE(occurrences(form.vertex, varying), 2u) << varying;
    }
}

TEST(Emit, lines_name_their_nodes) {
    const Module module = expand(base_and_detail(), {});
    for (const Form form : {Form::function, Form::shader}) {
        const Shader shader = emit(module, options(form));
        const auto lines = lines_of(form == Form::function ? shader.source : shader.fragment);
        ASSERT_EQ(lines.size(), shader.reflection.lines.size());
        bool found = false;
        for (size_t i = 0; i < lines.size(); ++i) {
            if (lines[i].find("texture(strap_weave_image") == std::string::npos) continue;
            found = true;
            EXPECT_EQ(shader.reflection.node_paths[shader.reflection.lines[i]], "weave");
        }
        EXPECT_TRUE(found);
    }
}

TEST(Emit, text_does_not_depend_on_creation_order) {
    const Module one = expand(base_and_detail(SurfaceInput::uv1_, false), {});
    const Module other = expand(base_and_detail(SurfaceInput::uv1_, true), {});
    EXPECT_EQ(emit(one, options()).source, emit(other, options()).source);
    EXPECT_EQ(emit(one, options(Form::shader)).fragment,
              emit(other, options(Form::shader)).fragment);
}

TEST(Emit, names_survive_an_unrelated_edit) {
    Module graph = base_and_detail();
    node(graph, "rough", "Noise");
    output(graph, "roughness", graph.swizzle(graph.input(SurfaceInput::uv2_), "x"));
    const std::string before = emit(expand(base_and_detail(), {}), options()).source;
    const std::string after = emit(expand(graph, {}), options()).source;
    const auto body = [](const std::string& text) {
        const size_t from = text.find(" wrinkle_strap(");
        return text.substr(from, text.find("\n    m.", from) - from);
    };
    EXPECT_EQ(body(before), body(after));
}

TEST(Emit, constants_need_no_struct) {
    Module m;
    output(m, "roughness", m.number(0.5));
    output(m, "color", m.constant(Type::vec3_, std::array{0.25, 0.25, 0.25}), WR_PORT_color);
    const Shader shader = emit(m, options());
    EXPECT_EQ(compile_errors(shader), "");
    EXPECT_EQ(shader.reflection.struct_name, "");
    EXPECT_NE(shader.source.find("WrinkleMaterial_strap wrinkle_strap() {\n"
                                 "    WrinkleMaterial_strap m;\n    m.roughness = 0.5;\n"
                                 "    m.color = vec3(0.25);\n    return m;\n}\n"),
              std::string::npos)
        << shader.source;
    EXPECT_EQ(compile_errors(emit(m, options(Form::shader))), "");
}

TEST(Emit, refuses_what_it_cannot_write) {
    Module m;
    EXPECT_EQ(emit(m, options()).problems.size(), 1u);
    output(m, "roughness", m.number(1));
    const Shader given = emit(m, options(Form::shader, Differentials::given));
    ASSERT_EQ(given.problems.size(), 1u);
    EXPECT_NE(given.problems[0].expected.find("function"), std::string::npos);
    EXPECT_TRUE(given.vertex.empty() && given.fragment.empty());
    output(m, "color", m.zero(Type::vec3_));
    EmitOptions bare = options();
    bare.bare_result = true;
    EXPECT_EQ(emit(m, bare).problems.size(), 1u);
    m.outputs[1].value = poison;
    const Shader poisoned = emit(m, options());
    ASSERT_EQ(poisoned.problems.size(), 1u);
    EXPECT_NE(poisoned.problems[0].message.find("'color'"), std::string::npos);
    EXPECT_TRUE(poisoned.source.empty());
}

TEST(Emit, merged_sampler_takes_its_first_reader_in_the_text) {
    Module m;
    const Id uv = m.input(SurfaceInput::uv0_);
    node(m, "late", "Image");
    const Id late = image(m, "image", "a.png", m.swizzle(uv, "yx"));
    node(m, "early", "Image");
    const Id early = image(m, "picture", "a.png", uv);
    output(m, "color", m.add(Op::add_, {early, late}));
    const Shader shader = emit(m, options());
    EXPECT_EQ(compile_errors(shader), "");
    ASSERT_EQ(shader.reflection.samplers.size(), 1u);
    EXPECT_EQ(shader.reflection.samplers[0].name, "strap_early_picture");
    EXPECT_EQ(shader.reflection.samplers[0].readers.size(), 2u);
}

TEST(Emit, OutputsShareTheirStatements) {
    Module m;
    node(m, "map", "Image");
    const Id texel = image(m, "image", "a.png", m.input(SurfaceInput::uv0_));
    output(m, "color", m.add(Op::mul_, {texel, texel}));
    output(m, "roughness", m.swizzle(texel, "x"));
    output(m, "output", m.swizzle(texel, "y"));
    const Shader shader = emit(m, options());
    EXPECT_EQ(compile_errors(shader), "");
    EXPECT_EQ(occurrences(shader.source, "texture("), 1u) << shader.source;
    EXPECT_NE(shader.source.find("m.output_2 = "), std::string::npos) << "a reserved word";
    EXPECT_EQ(shader.reflection.outputs[2].member, "output_2");
}

TEST(Emit, ABareResultIsTheValueOfTheOnlyOutput) {
    Module m;
    output(m, "roughness", m.swizzle(m.input(SurfaceInput::uv0_), "x"));
    EmitOptions bare = options();
    bare.bare_result = true;
    const Shader shader = emit(m, bare);
    EXPECT_EQ(compile_errors(shader), "");
    EXPECT_EQ(shader.reflection.result_name, "");
    EXPECT_NE(shader.source.find("float wrinkle_strap(WrinkleSurface_strap s) {\n"
                                 "    return s.uv0.x;\n}\n"),
              std::string::npos)
        << shader.source;
    bare.form = Form::shader;
    EXPECT_EQ(compile_errors(emit(m, bare)), "");
}

TEST(Emit, AMaterialIsCalledLikeItsFile) {
    EXPECT_EQ(material_name("graphs/woven strap.v2.json"), "woven_strap_v2");
    EXPECT_EQ(material_name("2nd.json"), "n2nd");
    EXPECT_EQ(material_name("-"), "stdin");
}

}  // namespace
}  // namespace wrinkle::test

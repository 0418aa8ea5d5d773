// Tests of the rules of each target: source, resource bindings, errors.
#include <gtest/gtest.h>

#include <set>

#include "emit/blocks.h"
#include "glslang/validate.h"
#include "golden.h"
#include "graphs.h"
#include "ir/expand.h"

namespace wrinkle::test {
namespace {

EmitOptions options(const char* target, Form form) {
    EmitOptions result;
    result.target = find_target(target);
    result.form = form;
    result.name = "strap";
    return result;
}

// Parameters of every width, in an order that leaves gaps in std140.
Module many_uniforms() {
    Module m;
    Id sum = m.number(0);
    const Type types[] = {Type::float_, Type::vec3_, Type::float_, Type::vec2_,
                          Type::vec4_,  Type::vec2_, Type::vec3_,  Type::vec3_};
    int number = 0;
    for (const Type type : types) {
        node(m, "n" + std::to_string(++number), "Node");
        const Id value = parameter(m, "value", 2, type);
        sum = m.add(Op::add_, {sum, type == Type::float_ ? value : m.swizzle(value, "y")});
    }
    const Id texel = image(m, "image", "a.png", m.input(SurfaceInput::uv0_));
    output(m, "roughness", m.add(Op::mul_, {sum, m.swizzle(texel, "x")}));
    output(m, "normal", m.input(SurfaceInput::view_), WR_PORT_normal);
    return m;
}

void expect_places(const Reflection& r, const std::string& text, Stage stage) {
    std::map<std::string, Place> found = places(text, stage);
    for (const auto& block : {r.frame_block, r.parameter_block}) {
        if (!block || !found.count(block->name)) continue;
        EXPECT_EQ(found[block->name].binding, block->binding.binding) << block->name;
        // std140 rounds the size of a block up; glslang reports the end of its last member.
        EXPECT_EQ((found[block->name].size + 15) / 16 * 16, block->size) << block->name;
    }
    for (const FrameUniform& u : r.frame_uniforms) {
        if (!found.count(u.name)) continue;
        EXPECT_EQ(found[u.name].offset, u.offset) << u.name;
    }
    if (stage == Stage::vertex) return;
    for (const UniformInfo& u : r.uniforms) {
        ASSERT_TRUE(found.count(u.name)) << u.name;
        EXPECT_EQ(found[u.name].offset, u.offset) << u.name;
    }
    for (const SamplerInfo& s : r.samplers)
        EXPECT_EQ(found[s.name].binding, s.binding.binding) << s.name;
}

TEST(Targets, WriteTheSampleByTheirRules) {
    const Module module = expand(base_and_detail(), {});
    for (const char* name : {"glsl450", "essl300"}) {
        const std::string target = std::string(".") + name;
        const Shader functions = emit(module, options(name, Form::function));
        EXPECT_EQ(compile_errors(functions), "");
        EXPECT_TRUE(equals_golden(functions.source, "base_and_detail" + target + ".glsl"));
        const Shader whole = emit(module, options(name, Form::shader));
        EXPECT_EQ(compile_errors(whole), "");
        EXPECT_TRUE(equals_golden(whole.vertex, "base_and_detail" + target + ".vert"));
        EXPECT_TRUE(equals_golden(whole.fragment, "base_and_detail" + target + ".frag"));
    }
}

TEST(Targets, NumberTheirResourcesAsGlslangFindsThem) {
    const Module module = many_uniforms();
    for (const int first : {0, 5}) {
        EmitOptions wanted = options("glsl450", Form::shader);
        wanted.first_binding = first;
        const Shader shader = emit(module, wanted);
        ASSERT_EQ(compile_errors(shader), "");
        ASSERT_TRUE(shader.reflection.frame_block && shader.reflection.parameter_block);
        EXPECT_EQ(shader.reflection.samplers[0].binding.binding, first + 2);
        expect_places(shader.reflection, shader.vertex, Stage::vertex);
        expect_places(shader.reflection, shader.fragment, Stage::fragment);
        wanted.form = Form::function;
        const Shader functions = emit(module, wanted);
        EXPECT_FALSE(functions.reflection.frame_block);
        EXPECT_EQ(functions.reflection.parameter_block->binding.binding, first);
        expect_places(functions.reflection, wrapped({&functions, 1}), Stage::fragment);
    }
}

TEST(Targets, StandInTheSetThatIsAskedFor) {
    EmitOptions wanted = options("glsl450", Form::function);
    wanted.set = 3;
    const Shader shader = emit(many_uniforms(), wanted);
    EXPECT_EQ(compile_errors(shader), "");
    EXPECT_NE(shader.source.find("set = 3, binding = 0) uniform WrinkleParameters_strap"),
              std::string::npos);
    EXPECT_NE(shader.source.find("set = 3, binding = 1) uniform sampler2D"), std::string::npos);
    EXPECT_NE(to_json(shader.reflection).find("\"set\": 3, \"binding\": 1"), std::string::npos);
}

TEST(Targets, OfOpenGlHaveNoNumbers) {
    for (const char* name : {"glsl330", "essl300"}) {
        const Reflection r = emit(many_uniforms(), options(name, Form::shader)).reflection;
        EXPECT_EQ(to_json(r).find("binding"), std::string::npos);
        EXPECT_EQ(to_json(r).find("offset"), std::string::npos);
        EXPECT_NE(to_json(r).find("\"target\": \"" + std::string(name)), std::string::npos);
    }
}

TEST(Targets, OutputsFollowOneAnotherWithoutGaps) {
    Module m;
    const Id value = m.swizzle(m.input(SurfaceInput::uv0_), "x");
    for (const char* name :
         {"second", "displacement", "first", "height", "color", "emission", "most"})
        output(m, name, value);
    for (const Target& target : targets()) {
        if (!supports(target, Form::shader)) continue;
        const Shader shader = emit(m, options(std::string(target.name).c_str(), Form::shader));
        if (has_validator(target)) {
            EXPECT_EQ(compile_errors(shader), "");
        }
        std::map<std::string, int> at;
        std::set<int> locations;
        for (const OutputInfo& each : shader.reflection.outputs)
            locations.insert(at[each.output] = each.location);
        EXPECT_EQ(locations, (std::set<int>{0, 1, 2, 3, 4, 5, 6}));
        EXPECT_EQ(at["color"], 0);
        EXPECT_EQ(at["height"], 1);
        EXPECT_EQ(at["displacement"], 2);
        EXPECT_EQ(at["emission"], 3);
        EXPECT_EQ(at["second"], 4);
        EXPECT_EQ(at["most"], 6);
    }
}

TEST(Targets, AreFoundByTheirNames) {
    std::set<std::string_view> names;
    for (const Target& target : targets()) {
        EXPECT_EQ(find_target(target.name), &target);
        EXPECT_TRUE(names.insert(target.name).second);
    }
    EXPECT_EQ(find_target("glsl120"), nullptr);
}

}  // namespace
}  // namespace wrinkle::test

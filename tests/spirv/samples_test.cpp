// Tests of every sample graph in every language: on each target, in each form it has, with both
// kinds of parameters.
#include <gtest/gtest.h>

#include "glslang/validate.h"
#include "graph/subgraph.h"
#include "ir/rewrite.h"
#include "lower/material.h"
#include "spirv/judge.h"
#include "spirv/spirv.h"
#include "support/linked_nodes.h"
#include "support/samples.h"

namespace wrinkle::test {
namespace {

Module module_of(const std::filesystem::path& graph, bool uniforms) {
    Diagnostics diagnostics;
    const Project project = load_project(graph, {}, diagnostics);
    MaterialOptions options;
    options.uniform_parameters = uniforms;
    Compiled compiled = compile_material(project, linked_nodes(), options, diagnostics);
    EXPECT_TRUE(compiled.ok) << graph << to_text(diagnostics);
    return std::move(compiled.module);
}

class Samples : public testing::TestWithParam<std::string_view> {};

TEST_P(Samples, AreValid) {
    const Target& target = *find_target(GetParam());
    for (const std::filesystem::path& graph : sample_graphs())
        for (const bool uniforms : {false, true}) {
            const Module module = module_of(graph, uniforms);
            for (const Form form : {Form::function, Form::shader}) {
                if (!supports(target, form)) continue;
                EmitOptions options;
                options.target = &target;
                options.form = form;
                options.name = material_name(graph);
                const Shader shader = write_shader(module, options);
                EXPECT_EQ(errors_of(shader), "") << graph << (uniforms ? " uniform" : " baked");
            }
        }
}

// A renderer includes many materials in one shader: no global name of theirs may occur twice.
TEST_P(Samples, FitIntoOneShader) {
    const Target& target = *find_target(GetParam());
    if (!has_validator(target) || !supports(target, Form::function)) return;
    for (const bool uniforms : {false, true}) {
        std::vector<Shader> shaders;
        EmitOptions options;
        options.target = &target;
        for (const std::filesystem::path& graph : sample_graphs()) {
            options.name = material_name(graph);
            shaders.push_back(write_shader(module_of(graph, uniforms), options));
            options.first_binding +=
                static_cast<int>(shaders.back().reflection.samplers.size()) + 1;
        }
        EXPECT_GE(shaders.size(), 28U);
        const std::string text = wrapped(shaders);
        const std::string errors = target.name == "hlsl" ? hlsl_errors(text, Stage::fragment)
                                                         : compile_errors(text, Stage::fragment);
        EXPECT_TRUE(errors.empty()) << errors.substr(0, 1000);
    }
}

// Without differentials no sample takes derivatives of the screen: all outputs compile for a vertex
// stage, images included.
TEST(VertexStage, TakesEverySample) {
    for (const std::filesystem::path& graph : sample_graphs()) {
        EmitOptions options;
        options.differentials = Differentials::none;
        const Shader shader = emit(without_differentials(module_of(graph, false)), options);
        EXPECT_FALSE(shader.reflection.uniform_control_flow) << graph;
        std::string text = wrapped({&shader, 1});
        constexpr std::string_view location = "layout(location = 0) out";  // fragment stage only
        text.replace(text.find(location), location.size(), "out");
        EXPECT_EQ(compile_errors(text, Stage::vertex), "") << graph;
    }
}

std::vector<std::string_view> target_names() {
    std::vector<std::string_view> names;
    for (const Target& target : targets())
        names.push_back(target.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Targets, Samples, testing::ValuesIn(target_names()),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace wrinkle::test

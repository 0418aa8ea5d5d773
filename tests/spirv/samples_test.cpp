// Every sample graph in every language: on each target, in each form that it has, with both kinds
// of parameters. GLSL is judged by glslang by the rules of each target, SPIR-V by spirv-val, HLSL
// by glslang's front end for it, Metal by what the reflection says.
#include <gtest/gtest.h>

#include "glslang/validate.h"
#include "graph/subgraph.h"
#include "lower/material.h"
#include "nodes/all.h"
#include "spirv/metal.h"
#include "spirv/spirv.h"
#include "support/samples.h"

namespace wrinkle::test {
namespace {

const Registry& nodes() {
    static const Registry registry = [] {
        Registry made;
        Diagnostics ignored;
        made.add_plugin(built_in_nodes(), Registry::built_in, ignored);
        return made;
    }();
    return registry;
}

std::string spirv_errors(const std::string& bytes) {
    std::string log;
    if (bytes.size() % 4 != 0 || !bytes.starts_with("\x03\x02\x23\x07")) return "no SPIR-V";
    return is_valid(words_of(bytes), log) ? "" : log + disassembly(bytes);
}

std::string errors_of(const Shader& shader) {
    const std::string& target = shader.reflection.target;
    if (!shader.problems.empty()) return shader.problems[0].message;
    if (target == "spirv") return spirv_errors(shader.vertex) + spirv_errors(shader.fragment);
    if (target == "hlsl")
        return hlsl_errors(shader.vertex, Stage::vertex) +
               hlsl_errors(shader.fragment, Stage::fragment);
    if (target == "msl") return metal_errors(shader);
    return compile_errors(shader);
}

Module module_of(const std::filesystem::path& graph, bool uniforms) {
    Diagnostics diagnostics;
    const Project project = load_project(graph, {}, diagnostics);
    MaterialOptions options;
    options.uniform_parameters = uniforms;
    Compiled compiled = compile_material(project, nodes(), options, diagnostics);
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
                if (form == Form::function && is_translated(target)) continue;
                EmitOptions options;
                options.target = &target;
                options.form = form;
                options.name = material_name(graph);
                const Shader shader = write_shader(module, options);
                EXPECT_EQ(errors_of(shader), "") << graph << (uniforms ? " uniform" : " baked");
            }
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

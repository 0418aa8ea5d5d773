#include "compile/shader.h"

#include <algorithm>

#include "base/checksum.h"
#include "base/diagnostics.h"
#include "base/text.h"
#include "cost/limits.h"
#include "cpu/texture_store.h"
#include "graph/document.h"
#include "graph/subgraph.h"
#include "image/formats.h"
#include "ir/rewrite.h"
#include "ir/tangent_space.h"
#include "lower/check.h"
#include "lower/exposed.h"
#include "spirv/spirv.h"

namespace wrinkle {
namespace {

// Returns the image's problem at the port that names the file.
Diagnostic at_reader(const Diagnostic& problem, const Resource& resource, const Compiled& compiled,
                     const Project& project) {
    if (resource.readers.empty()) return problem;
    const Resource::Reader& reader = resource.readers.front();
    const NodePlace place = compiled.places[reader.node];
    if (place.node == NodePlace::none) return problem;
    const Document& document = project.files[place.file].document;
    Diagnostic result = diagnose_port(document, *document.nodes[place.node], reader.port,
                                      problem.rule, problem.message, problem.expected);
    result.severity = problem.severity;
    result.node = compiled.module.nodes[reader.node].path;
    return result;
}

// Warns of images that a host is likely to cut to 8 bits: no GPU format of 16 bits is sRGB.
void warn_of_16_bits(const Reflection& reflection, const Compiled& compiled, const Project& project,
                     Diagnostics& diagnostics) {
    for (const SamplerInfo& sampler : reflection.samplers) {
        if (!sampler.options.decodes_texels() || png_bits(sampler.file) != 16) continue;
        const Diagnostic warning =
            file_problem(Severity::warning, RuleId::texture_precision, "",
                         "image '" + sampler.written +
                             "' has 16 bits per channel and encoding srgb, for which no texture "
                             "format exists",
                         "decode it when it is loaded, to rgba16; as srgb8 it loses 8 bits");
        diagnostics.add(
            at_reader(warning, compiled.module.resources[sampler.resource], compiled, project));
    }
}

std::string uniform_of(const Reflection& reflection, const std::string& input) {
    for (const UniformInfo& uniform : reflection.uniforms)
        if (uniform.graph_input && uniform.port == input) return uniform.name;
    return {};
}

// Returns a list with one input of the top graph per line.
std::string inputs_json(const Reflection& reflection, const Project& project,
                        const Registry& registry) {
    const auto& inputs = project.top().inputs;
    if (inputs.empty()) return "[]";
    const Types types(project, registry);
    std::string text = "[";
    for (size_t i = 0; i < inputs.size(); ++i)
        text += (i ? ",\n    " : "\n    ") + exposed_input(inputs[i], types.graph_input(0, i),
                                                           uniform_of(reflection, inputs[i].name));
    return text + "\n  ]";
}

}  // namespace

std::string form_conflict(const Target& target, Form form, Differentials differentials,
                          std::optional<NormalSpace> normal_space) {
    if (!supports(target, form))
        return "the target '" + std::string(target.name) + "' is only written as a " +
               (form == Form::function ? "complete pair" : "function");
    if (form == Form::shader && differentials != Differentials::screen)
        return "the shader form takes its differentials from the screen";
    if (form == Form::shader && normal_space.value_or(NormalSpace::world) != NormalSpace::world)
        return "the shader form writes normals in world space";
    return {};
}

void follow_double_sided(Document& document, const std::string& mesh, Diagnostics& diagnostics) {
    if (document.back_faces) return;
    document.back_faces = BackFaces::flip;
    diagnostics.add(
        file_problem(Severity::warning, RuleId::double_sided, mesh,
                     "a material is doubleSided, so back faces are drawn by the rule 'flip'",
                     "\"back_faces\" in the graph chooses the rule"));
}

Compiled compile_or_check(const Project& project, const Registry& registry,
                          const MaterialOptions& options, Diagnostics& diagnostics) {
    if (!diagnostics.has_errors()) return compile_material(project, registry, options, diagnostics);
    check(project, registry, Types(project, registry), diagnostics);
    return {};
}

void report_emit(const Shader& shader, const Compiled& compiled, const Project& project,
                 Diagnostics& diagnostics) {
    report_problems(shader.problems, compiled.module, project, compiled.places, diagnostics);
}

void check_limits(const Reflection& reflection, const std::string& file, bool strict,
                  Diagnostics& diagnostics) {
    for (const Excess& excess : {texture_unit_excess(reflection), draw_buffer_excess(reflection)}) {
        if (excess.problem.empty()) continue;
        diagnostics.add(file_problem(strict ? Severity::error : Severity::warning,
                                     RuleId::gpu_limit, file, excess.problem, excess.remedy));
    }
}

MadeShader make_shader(const Project& project, const Registry& registry, ShaderOptions options,
                       Diagnostics& diagnostics) {
    MadeShader made;
    options.material.given_differentials = options.emit.differentials == Differentials::given;
    options.material.lower.outputs = options.outputs;
    made.compiled = compile_or_check(project, registry, options.material, diagnostics);
    if (!made.compiled.ok) return made;
    Module& module = made.compiled.module;
    options.emit.bare_result = options.outputs.size() == 1;
    if (options.emit.normal_space == NormalSpace::tangent)
        module = with_tangent_space_normals(std::move(module), options.material.vertex_tangents);
    if (options.emit.differentials == Differentials::none)
        module = without_differentials(std::move(module));
    if (options.emit.uv_origin == UvOrigin::top) module = with_uv_origin_top(std::move(module));
    module = nest_loops(std::move(module));
    made.shader = write_shader(made.compiled.module, options.emit);
    report_emit(made.shader, made.compiled, project, diagnostics);
    check_limits(made.shader.reflection, project.top().file, options.strict, diagnostics);
    warn_of_16_bits(made.shader.reflection, made.compiled, project, diagnostics);
    return made;
}

std::string reflection_json(const Shader& shader, const Project& project,
                            const Registry& registry) {
    std::string sums;
    const auto add = [&](const char* name, const std::string& text) {
        if (text.empty()) return;
        sums += (sums.empty() ? "" : ", ") + json_quoted(name) + ": " + json_quoted(sha256(text));
    };
    add("function", shader.source);
    add("vertex", shader.vertex);
    add("fragment", shader.fragment);
    std::string text = to_json(shader.reflection);
    text.resize(text.rfind("\n}"));
    text += ",\n  \"inputs\": " + inputs_json(shader.reflection, project, registry);
    return text + ",\n  \"sha256\": {" + sums + "}\n}\n";
}

void read_textures(TextureStore& textures, const Compiled& compiled, const Project& project,
                   Diagnostics& diagnostics) {
    for (const Resource& resource : compiled.module.resources) {
        Diagnostics own;
        textures.read(texels_of(resource), own);
        for (const Diagnostic& problem : own.list())
            diagnostics.add(at_reader(problem, resource, compiled, project));
    }
}

}  // namespace wrinkle

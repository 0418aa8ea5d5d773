#include "cli/compile_graph.h"

#include "base/diagnostics.h"
#include "base/dynamic_library.h"
#include "base/printable.h"
#include "base/text.h"
#include "cli/cache_entry.h"
#include "cli/cli.h"
#include "cli/outputs.h"
#include "cost/report.h"
#include "spirv/spirv.h"

namespace wrinkle::cli {
namespace {

std::string name_for(const std::string& file, const TextOptions& options) {
    return options.name.empty() ? material_name(file) : options.name;
}

// Returns the cost report as a table or as JSON; "" and an error on failure.
std::string cost_of(const Module& module, Differentials differentials, bool json,
                    const std::string& file, Diagnostics& diagnostics) {
    std::string why;
    const auto report = measure_cost(module, differentials, why);
    if (report) return json ? to_json(*report) : to_text(*report);
    diagnostics.add(file_problem(Severity::error, RuleId::shader_rejected, file,
                                 "its cost cannot be counted: " + why, ""));
    return {};
}

void make_texts(const std::string& file, const Project& project, const Compilation& with,
                CompiledGraph& result) {
    const TextOptions& wanted = with.options;
    const ShaderOptions options = shader_options(file, with);
    MadeShader made = make_shader(project, with.registry, options, result.diagnostics);
    Shader& shader = made.shader;
    result.over_limit = made.compiled.over_limit || shader.over_limit;
    if (wanted.cost && !result.diagnostics.has_errors())
        result.cost = cost_of(made.compiled.module, options.emit.differentials, wanted.json, file,
                              result.diagnostics);
    if (result.diagnostics.has_errors()) return;
    if (wanted.reflects) result.reflection = reflection_json(shader, project, with.registry);
    result.texts = blank_texts(wanted);
    for (Text& text : result.texts)
        text.bytes = std::move(text.stage.empty()       ? shader.source
                               : text.stage == "vertex" ? shader.vertex
                                                        : shader.fragment);
}

Differentials differentials_of(const TextOptions& options) {
    const bool vertex = options.outputs == std::vector<std::string>{"displacement"};
    if (options.differentials.empty()) return vertex ? Differentials::none : Differentials::screen;
    return options.differentials == "given"  ? Differentials::given
           : options.differentials == "none" ? Differentials::none
                                             : Differentials::screen;
}

std::optional<NormalSpace> normal_space_of(const TextOptions& options) {
    return enumerator_named<NormalSpace>(normal_space_names, options.normal_space);
}

}  // namespace

void declare_text(CLI::App& sub, TextOptions& text) {
    sub.add_option("--target", text.target, "The language to write")->capture_default_str();
    add_choice(sub, "--form", text.form, {"function", "shader"},
               "A function for your shader (the default of GLSL), or a complete pair");
    sub.add_option("--outputs", text.outputs,
                   "Outputs to compute, separated by commas; default: all. A single one is "
                   "returned without a struct")
        ->type_name("LIST")
        ->delimiter(',');
    add_choice(sub, "--params", text.params, {"baked", "uniform"},
               "Numbers as literals or as uniforms");
    add_choice(sub, "--differentials", text.differentials, {"screen", "given", "none"},
               "Taken from the screen, passed by the caller, or zero, for a vertex stage; default: "
               "screen, and none for --outputs displacement");
    add_choice(sub, "--srgb", text.srgb, {"sampler", "shader"},
               "The decoder of images of encoding srgb: the sampler, or the text for hosts without "
               "sRGB textures");
    add_choice(sub, "--uv-origin", text.uv_origin, uv_origin_names,
               "Where v is 0, and which row of an image is uploaded first");
    add_choice(sub, "--normal-space", text.normal_space, normal_space_names,
               "The space of the function's normals; default: object. Those of a pair are in world "
               "space");
    sub.add_option("--descriptor-set", text.set, "The descriptor set of the blocks and images")
        ->check(CLI::Range(0, max_descriptor_set))
        ->capture_default_str();
    sub.add_option("--first-binding", text.first_binding, "The binding of the first of them")
        ->check(CLI::Range(0, max_first_binding))
        ->capture_default_str();
    sub.add_option("--name", text.name, "NAME in the text; default: the file's stem");
}

std::string wrong_text(const TextOptions& text) {
    const Target* target = find_target(text.target);
    if (!target) return "there is no target '" + text.target + "'; --list-targets lists them";
    const Form form = form_of(text);
    const std::string why =
        form_conflict(*target, form, differentials_of(text), normal_space_of(text));
    if (why.empty() || supports(*target, form)) return why;
    return why + "; --form " + (form == Form::shader ? "function" : "shader");
}

ShaderOptions shader_options(const std::string& file, const Compilation& with) {
    const TextOptions& wanted = with.options;
    ShaderOptions options;
    options.material.uniform_parameters = wanted.params == "uniform";
    options.material.vertex_tangents = !with.common.no_tangents;
    if (wanted.cost) options.material.runs_calls = "--cost";
    options.material.lower.max_values /= with.sharing;
    if (wanted.srgb == "shader") options.material.lower.srgb = SrgbDecoder::shader;
    options.emit.max_bytes /= with.sharing;
    options.emit.form = form_of(wanted);
    options.emit.differentials = differentials_of(wanted);
    if (wanted.uv_origin == "top") options.emit.uv_origin = UvOrigin::top;
    options.emit.normal_space = normal_space_of(wanted).value_or(NormalSpace::object);
    options.emit.name = name_for(file, wanted);
    options.emit.target = find_target(wanted.target);
    options.emit.set = wanted.set;
    options.emit.first_binding = wanted.first_binding;
    options.outputs = wanted.outputs;
    options.strict = wanted.strict;
    return options;
}

Form form_of(const TextOptions& options) {
    if (options.form.empty()) return default_form(*find_target(options.target));
    return options.form == "shader" ? Form::shader : Form::function;
}

bool needs_compilers(const TextOptions& options) {
    return options.cost || is_binary(*find_target(options.target));
}

bool have_compilers(const TextOptions& options, std::string& why) {
    if (!needs_compilers(options) || have_spirv_tools(why)) return true;
    why += std::string("; ") + library_remedy;
    return false;
}

std::vector<Text> blank_texts(const TextOptions& options) {
    if (form_of(options) == Form::function) return {{"", "", ""}};
    const std::string suffix(find_target(options.target)->suffix);
    return {{"vertex", vertex_suffix + suffix, ""}, {"fragment", fragment_suffix + suffix, ""}};
}

CompiledGraph compile_graph(const std::string& file, const Compilation& with) {
    CompiledGraph result;
    const Project read = open_project(file, with.common, result.diagnostics);
    const Project project =
        project_of_run(read, with.registry, with.overrides, 0, result.diagnostics);
    std::string key;
    if (!result.diagnostics.has_errors()) {
        const Types types(project, with.registry);
        result.inputs = inputs_of(project, types);
        if (with.cache) key = cache_key(project, types, name_for(file, with.options), with);
        if (!key.empty() && take_entry(with, key, project, result)) return result;
    }
    make_texts(file, project, with, result);
    if (!key.empty() && !result.texts.empty()) store_entry(with, key, project, result);
    return result;
}

std::string printed_costs(std::span<const GraphCost> costs, bool several, bool json) {
    std::string text;
    for (const GraphCost& each : costs) {
        if (json)
            text += (text.empty() ? "\n" : ",\n") + ("{\"file\": " + json_quoted(each.file)) +
                    ", \"cost\":\n" + each.report + "}";
        else
            text += (text.empty() ? "" : "\n") + (several ? printable(each.file) + "\n" : "") +
                    each.report;
    }
    return json ? "{\"version\": 1, \"graphs\": [" + text + "\n]}\n" : text;
}

}  // namespace wrinkle::cli

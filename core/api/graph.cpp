#include "api/parts.h"
#include "base/text.h"
#include "compile/inputs.h"
#include "lower/exposed.h"

namespace wrinkle::api {
namespace {

// The enumerators after of_form have the order of the compiler's.
static_assert(static_cast<int>(CompileOptions::NormalSpace::tangent) ==
              static_cast<int>(NormalSpace::tangent) + 1);

std::optional<NormalSpace> normal_space_of(const CompileOptions& wanted) {
    if (wanted.normal_space == CompileOptions::NormalSpace::of_form) return std::nullopt;
    return static_cast<NormalSpace>(static_cast<int>(wanted.normal_space) - 1);
}

// Returns the emitter's options and reports invalid ones.
EmitOptions emit_options(const CompileOptions& wanted, const std::string& file,
                         Diagnostics& diagnostics) {
    EmitOptions options;
    options.target = find_target(wanted.target);
    if (!options.target) {
        const std::vector<std::string> names = targets();
        diagnostics.error(RuleId::target, "there is no target '" + wanted.target + "'",
                          did_you_mean(wanted.target, names, joined(names, ", ")));
        return options;
    }
    if (wanted.form == CompileOptions::Form::of_target)
        options.form = default_form(*options.target);
    else
        options.form = wanted.form == CompileOptions::Form::shader ? Form::shader : Form::function;
    options.differentials = wanted.differentials == CompileOptions::Differentials::given
                                ? Differentials::given
                                : Differentials::screen;
    if (wanted.uv_origin == CompileOptions::UvOrigin::top) options.uv_origin = UvOrigin::top;
    options.name = wanted.name.empty() ? material_name(file) : wanted.name;
    options.set = wanted.descriptor_set;
    options.first_binding = wanted.first_binding;
    const auto within = [&](const char* what, int value, int most) {
        if (value < 0 || value > most)
            diagnostics.error(RuleId::option, std::string(what) + " is " + std::to_string(value),
                              "0 to " + std::to_string(most));
    };
    within("descriptor_set", options.set, max_descriptor_set);
    within("first_binding", options.first_binding, max_first_binding);
    const std::optional<NormalSpace> normal_space = normal_space_of(wanted);
    options.normal_space = normal_space.value_or(NormalSpace::object);
    const std::string conflict =
        form_conflict(*options.target, options.form, options.differentials, normal_space);
    if (!conflict.empty()) diagnostics.error(RuleId::target, conflict);
    return options;
}

std::shared_ptr<const Prepared> prepare(const Graph::Parts& parts, bool vertex_tangents) {
    auto prepared = std::make_shared<Prepared>();
    Diagnostics& problems = prepared->problems;
    problems = parts.problems;
    MaterialOptions options;
    options.given_differentials = true;
    options.vertex_tangents = vertex_tangents;
    options.runs_calls = "eval";
    const Compiled compiled =
        compile_or_check(parts.project, parts.library->registry, options, problems);
    if (!compiled.ok) return prepared;
    TextureStore textures;
    read_textures(textures, compiled, parts.project, problems);
    if (problems.has_errors()) return prepared;
    std::string why;
    prepared->program = compile_program(compiled.module, why);
    if (why.empty())
        prepared->textures = textures.textures_of(compiled.module.resources);
    else
        problems.error(RuleId::over_limit, why);
    return prepared;
}

// Calls work(parts, result). For an empty or unreadable graph, and for an exception, the result
// holds only the problems.
template <class Result, class Work>
Result guarded(const std::shared_ptr<const Graph::Parts>& parts, Work work) noexcept {
    Result result;
    try {
        if (parts && parts->whole)
            work(*parts, result);
        else
            result.problems = parts ? parts->unusable : no_graph();
    } catch (...) {
        result = Result();
        result.problems = caught();
    }
    return result;
}

}  // namespace

std::shared_ptr<const Prepared> prepared_once(const Graph::Parts& parts, bool vertex_tangents) {
    const std::lock_guard lock(parts.mutex);
    auto& prepared = parts.prepared[vertex_tangents ? 1 : 0];
    if (!prepared) prepared = prepare(parts, vertex_tangents);
    return prepared;
}

Graph::Graph() noexcept = default;
Graph::Graph(const Graph&) noexcept = default;
Graph::Graph(Graph&&) noexcept = default;
Graph& Graph::operator=(const Graph&) noexcept = default;
Graph& Graph::operator=(Graph&&) noexcept = default;
Graph::~Graph() = default;
Graph::Graph(std::shared_ptr<const Parts> parts) noexcept : parts_(std::move(parts)) {}

Problems Graph::check(bool vertex_tangents) const noexcept {
    struct Checked {
        Problems problems;
    };
    return guarded<Checked>(parts_,
                            [&](const Parts& parts, Checked& checked) {
                                Diagnostics all = parts.problems, each_once;
                                MaterialOptions options;
                                options.vertex_tangents = vertex_tangents;
                                compile_or_check(parts.project, parts.library->registry, options,
                                                 all);
                                each_once.append_once(all);
                                checked.problems = problems_of(each_once);
                            })
        .problems;
}

// The enumerators of both have the same order.
static_assert(static_cast<int>(InputFile::Kind::preset) ==
              static_cast<int>(wrinkle::InputFile::Kind::preset));

std::vector<InputFile> Graph::inputs() const noexcept {
    struct Listed {
        std::vector<InputFile> files;
        Problems problems;
    };
    return guarded<Listed>(parts_,
                           [&](const Parts& parts, Listed& listed) {
                               const Types types(parts.project, parts.library->registry);
                               for (wrinkle::InputFile& file : inputs_of(parts.project, types))
                                   listed.files.push_back({static_cast<InputFile::Kind>(file.kind),
                                                           std::move(file.path)});
                           })
        .files;
}

std::vector<Preset> Graph::presets() const noexcept {
    struct Listed {
        std::vector<Preset> presets;
        Problems problems;
    };
    return guarded<Listed>(parts_,
                           [&](const Parts& parts, Listed& listed) {
                               for (const wrinkle::Preset& preset : parts.project.top().presets) {
                                   Preset& added = listed.presets.emplace_back();
                                   added.name = preset.name;
                                   for (auto& [input, json] : preset_values(preset))
                                       added.values.push_back({input, json});
                               }
                           })
        .presets;
}

Shader Graph::compile(const CompileOptions& wanted) const noexcept {
    return guarded<Shader>(parts_, [&](const Parts& parts, Shader& result) {
        Diagnostics problems;
        ShaderOptions options;
        options.emit = emit_options(wanted, parts.project.top().file, problems);
        options.material.uniform_parameters =
            wanted.parameters == CompileOptions::Parameters::uniform;
        options.material.vertex_tangents = wanted.vertex_tangents;
        if (wanted.srgb == CompileOptions::Srgb::shader)
            options.material.lower.srgb = SrgbDecoder::shader;
        options.strict = wanted.strict;
        if (!problems.has_errors()) {
            problems = parts.problems;
            wrinkle::Shader made =
                make_shader(parts.project, parts.library->registry, options, problems).shader;
            result.ok = !problems.has_errors();
            if (result.ok) {
                result.reflection = reflection_json(made, parts.project, parts.library->registry);
                result.source = std::move(made.source);
                result.vertex = std::move(made.vertex);
                result.fragment = std::move(made.fragment);
            }
        }
        result.problems = problems_of(problems);
    });
}

Evaluated Graph::evaluate(const Points& points, const EvaluateOptions& options) const noexcept {
    return guarded<Evaluated>(parts_, [&](const Parts& parts, Evaluated& result) {
        const auto prepared = prepared_once(parts, options.vertex_tangents);
        result = evaluated_at(points, prepared->program, prepared->textures,
                              options.double_precision, prepared->problems);
    });
}

}  // namespace wrinkle::api

// The C interface, on top of the C++ one: each object holds a C++ value and the strings and arrays
// that its functions return.
#include <wrinkle/wrinkle.h>

#include <algorithm>
#include <deque>

#include "api/c_options.h"
#include "api/parts.h"

using namespace wrinkle::api;

struct wrinkle_problems {
    Problems list;
    std::deque<std::string> lines;  // texts of `each`
    std::vector<wrinkle_problem> each;
    std::string text;

    wrinkle_problems(wrinkle_problems&&) = default;  // the strings keep their addresses
    explicit wrinkle_problems(Problems problems) : list(std::move(problems)), text(to_text(list)) {
        for (const Problem& problem : list)
            each.push_back({problem.is_error, problem.file.c_str(), problem.line, problem.column,
                            problem.pointer.c_str(), problem.node.c_str(), problem.message.c_str(),
                            problem.expected.c_str(),
                            lines.emplace_back(to_text(problem)).c_str()});
    }
};

struct wrinkle_library {
    Library library;
    wrinkle_problems problems;
};

struct wrinkle_graph {
    Graph graph;
    std::vector<Preset> presets;

    explicit wrinkle_graph(Graph made) : graph(std::move(made)), presets(graph.presets()) {}
};

struct wrinkle_files {
    std::vector<std::string> names;
    wrinkle_problems problems;
};

struct wrinkle_shader {
    Shader shader;
    wrinkle_problems problems;

    explicit wrinkle_shader(Shader made)
        : shader(std::move(made)), problems(std::move(shader.problems)) {}
};

struct wrinkle_evaluator {
    Evaluator evaluator;
    wrinkle_problems problems;
    std::vector<Evaluator::Input> inputs;

    explicit wrinkle_evaluator(Evaluator made)
        : evaluator(std::move(made)), problems(evaluator.problems()), inputs(evaluator.inputs()) {}
};

struct wrinkle_points {
    Points points;
};

struct wrinkle_results {
    Evaluated evaluated;
    wrinkle_problems problems;

    explicit wrinkle_results(Evaluated made)
        : evaluated(std::move(made)), problems(std::move(evaluated.problems)) {}
};

namespace {

// Returns make(), or null without memory.
template <class Make>
auto made(Make make) noexcept -> decltype(make()) {
    try {
        return make();
    } catch (...) {
        return nullptr;
    }
}

std::string text_of(const char* text) {
    return text ? text : "";
}

std::vector<std::string> texts_of(const char* const* texts, size_t count) {
    std::vector<std::string> copies;
    for (size_t i = 0; texts && i < count; ++i)
        copies.push_back(text_of(texts[i]));
    return copies;
}

const char* text_of(const std::string& text, size_t* size) {
    if (size) *size = text.size();
    return text.c_str();
}

// Returns the element, or null if the index is too large.
template <class List>
auto at(const List& list, size_t index) noexcept -> decltype(list.data()) {
    return index < list.size() ? &list[index] : nullptr;
}

const char* no_text(size_t* size) {
    if (size) *size = 0;
    return nullptr;
}

Graph graph_of(const wrinkle_graph* graph) {
    return graph ? graph->graph : Graph();
}

}  // namespace

const char* wrinkle_version(void) {
    return version();
}

size_t wrinkle_problems_count(const wrinkle_problems* problems) {
    return problems ? problems->each.size() : 0;
}
const wrinkle_problem* wrinkle_problems_at(const wrinkle_problems* problems, size_t index) {
    return problems ? at(problems->each, index) : nullptr;
}
bool wrinkle_problems_have_errors(const wrinkle_problems* problems) {
    return problems && has_errors(problems->list);
}
const char* wrinkle_problems_text(const wrinkle_problems* problems) {
    return problems ? problems->text.c_str() : nullptr;
}
void wrinkle_problems_free(wrinkle_problems* problems) {
    delete problems;
}

wrinkle_library* wrinkle_library_new(const char* const* plugins, size_t count,
                                     bool default_plugins) {
    return made([&] {
        Library library({texts_of(plugins, count), default_plugins});
        wrinkle_problems problems(library.problems());
        return new wrinkle_library{std::move(library), std::move(problems)};
    });
}
const wrinkle_problems* wrinkle_library_problems(const wrinkle_library* library) {
    return library ? &library->problems : nullptr;
}
void wrinkle_library_free(wrinkle_library* library) {
    delete library;
}

wrinkle_graph* wrinkle_graph_load(const wrinkle_library* library, const char* file,
                                  const char* root) {
    return made([&] {
        return new wrinkle_graph(library ? library->library.load(text_of(file), text_of(root))
                                         : Graph());
    });
}
wrinkle_graph* wrinkle_graph_load_text(const wrinkle_library* library, const char* text,
                                       const char* folder, const char* name, const char* root) {
    return made([&] {
        return new wrinkle_graph(
            library ? library->library.load_text(text_of(text), folder ? folder : ".",
                                                 name ? name : "text", text_of(root))
                    : Graph());
    });
}
wrinkle_graph* wrinkle_graph_with(const wrinkle_graph* graph, const char* const* values,
                                  size_t count) {
    return made([&] { return new wrinkle_graph(graph_of(graph).with(texts_of(values, count))); });
}
wrinkle_graph* wrinkle_graph_with_preset(const wrinkle_graph* graph, const char* name) {
    return made([&] { return new wrinkle_graph(graph_of(graph).with_preset(text_of(name))); });
}
wrinkle_problems* wrinkle_graph_check(const wrinkle_graph* graph) {
    return made([&] { return new wrinkle_problems(graph_of(graph).check()); });
}
size_t wrinkle_graph_preset_count(const wrinkle_graph* graph) {
    return graph ? graph->presets.size() : 0;
}
const char* wrinkle_graph_preset(const wrinkle_graph* graph, size_t index) {
    const Preset* preset = graph ? at(graph->presets, index) : nullptr;
    return preset ? preset->name.c_str() : nullptr;
}
void wrinkle_graph_free(wrinkle_graph* graph) {
    delete graph;
}

wrinkle_files* wrinkle_graph_inputs(const wrinkle_graph* graph) {
    return made([&] {
        std::vector<std::string> names;
        for (InputFile& file : graph_of(graph).inputs())
            names.push_back(std::move(file.path));
        return new wrinkle_files{std::move(names), wrinkle_problems({})};
    });
}
size_t wrinkle_files_count(const wrinkle_files* files) {
    return files ? files->names.size() : 0;
}
const char* wrinkle_files_at(const wrinkle_files* files, size_t index) {
    const std::string* name = files ? at(files->names, index) : nullptr;
    return name ? name->c_str() : nullptr;
}
const wrinkle_problems* wrinkle_files_problems(const wrinkle_files* files) {
    return files ? &files->problems : nullptr;
}
void wrinkle_files_free(wrinkle_files* files) {
    delete files;
}

wrinkle_shader* wrinkle_graph_compile(const wrinkle_graph* graph, const char* const* options,
                                      size_t count) {
    return made([&] {
        CompileOptions chosen;
        wrinkle::Diagnostics diagnostics;
        for (const std::string& option : texts_of(options, count))
            set_option(chosen, option, diagnostics);
        Shader shader;
        if (diagnostics.has_errors())
            shader.problems = problems_of(diagnostics);
        else
            shader = graph_of(graph).compile(chosen);
        return new wrinkle_shader(std::move(shader));
    });
}
const wrinkle_problems* wrinkle_shader_problems(const wrinkle_shader* shader) {
    return shader ? &shader->problems : nullptr;
}
const char* wrinkle_shader_source(const wrinkle_shader* shader, size_t* size) {
    return shader ? text_of(shader->shader.source, size) : no_text(size);
}
const char* wrinkle_shader_vertex(const wrinkle_shader* shader, size_t* size) {
    return shader ? text_of(shader->shader.vertex, size) : no_text(size);
}
const char* wrinkle_shader_fragment(const wrinkle_shader* shader, size_t* size) {
    return shader ? text_of(shader->shader.fragment, size) : no_text(size);
}
const char* wrinkle_shader_reflection(const wrinkle_shader* shader, size_t* size) {
    return shader ? text_of(shader->shader.reflection, size) : no_text(size);
}
void wrinkle_shader_free(wrinkle_shader* shader) {
    delete shader;
}

wrinkle_files* wrinkle_graph_export(const wrinkle_graph* graph, const char* host,
                                    const char* folder, const char* mesh, uint32_t size,
                                    const char* name) {
    return made([&] {
        ExportOptions options;
        if (mesh) options.mesh = mesh;
        if (size) options.size = size;
        options.name = text_of(name);
        Exported exported = graph_of(graph).export_to(text_of(host), text_of(folder), options);
        return new wrinkle_files{std::move(exported.files),
                                 wrinkle_problems(std::move(exported.problems))};
    });
}

wrinkle_evaluator* wrinkle_evaluator_new(const wrinkle_graph* graph) {
    return made([&] { return new wrinkle_evaluator(graph_of(graph).evaluator()); });
}
wrinkle_evaluator* wrinkle_evaluator_copy(const wrinkle_evaluator* evaluator) {
    return made([&] {
        return new wrinkle_evaluator(evaluator ? evaluator->evaluator : Graph().evaluator());
    });
}
const wrinkle_problems* wrinkle_evaluator_problems(const wrinkle_evaluator* evaluator) {
    return evaluator ? &evaluator->problems : nullptr;
}
size_t wrinkle_evaluator_input_count(const wrinkle_evaluator* evaluator) {
    return evaluator ? evaluator->inputs.size() : 0;
}
const char* wrinkle_evaluator_input_name(const wrinkle_evaluator* evaluator, size_t input) {
    const auto* found = evaluator ? at(evaluator->inputs, input) : nullptr;
    return found ? found->name.c_str() : nullptr;
}
size_t wrinkle_evaluator_input_components(const wrinkle_evaluator* evaluator, size_t input) {
    const auto* found = evaluator ? at(evaluator->inputs, input) : nullptr;
    return found ? found->value.size() : 0;
}
const double* wrinkle_evaluator_input_value(const wrinkle_evaluator* evaluator, size_t input) {
    const auto* found = evaluator ? at(evaluator->inputs, input) : nullptr;
    return found ? found->value.data() : nullptr;
}
int wrinkle_evaluator_find(const wrinkle_evaluator* evaluator, const char* input) {
    if (!evaluator || !input) return -1;
    try {
        return evaluator->evaluator.find(input);
    } catch (...) {
        return -1;
    }
}
bool wrinkle_evaluator_set(wrinkle_evaluator* evaluator, int input, const double* value,
                           size_t components) {
    if (!evaluator || !value) return false;
    try {
        if (!evaluator->evaluator.set(input, {value, value + components}).empty()) return false;
        const auto index = static_cast<size_t>(input);
        const std::vector<double> clamped = evaluator->evaluator.inputs().at(index).value;
        std::ranges::copy(clamped, evaluator->inputs[index].value.begin());
        return true;
    } catch (...) {
        return false;
    }
}
void wrinkle_evaluator_free(wrinkle_evaluator* evaluator) {
    delete evaluator;
}

wrinkle_points* wrinkle_points_new(size_t count) {
    return made([&] { return new wrinkle_points{{count, {}}}; });
}
bool wrinkle_points_set(wrinkle_points* points, const char* name, const double* values,
                        size_t numbers) {
    if (!points || !name || !values) return false;
    try {
        points->points.values[name].assign(values, values + numbers);
        return true;
    } catch (...) {
        return false;
    }
}
void wrinkle_points_free(wrinkle_points* points) {
    delete points;
}

wrinkle_results* wrinkle_evaluator_evaluate(const wrinkle_evaluator* evaluator,
                                            const wrinkle_points* points, bool double_precision) {
    return made([&] {
        const Points none;
        return new wrinkle_results((evaluator ? evaluator->evaluator : Graph().evaluator())
                                       .evaluate(points ? points->points : none, double_precision));
    });
}
const wrinkle_problems* wrinkle_results_problems(const wrinkle_results* results) {
    return results ? &results->problems : nullptr;
}
size_t wrinkle_results_count(const wrinkle_results* results) {
    return results ? results->evaluated.outputs.size() : 0;
}
const char* wrinkle_results_name(const wrinkle_results* results, size_t output) {
    const Column* column = results ? at(results->evaluated.outputs, output) : nullptr;
    return column ? column->name.c_str() : nullptr;
}
size_t wrinkle_results_components(const wrinkle_results* results, size_t output) {
    const Column* column = results ? at(results->evaluated.outputs, output) : nullptr;
    return column ? column->components : 0;
}
const double* wrinkle_results_values(const wrinkle_results* results, size_t output) {
    const Column* column = results ? at(results->evaluated.outputs, output) : nullptr;
    return column ? column->values.data() : nullptr;
}
void wrinkle_results_free(wrinkle_results* results) {
    delete results;
}

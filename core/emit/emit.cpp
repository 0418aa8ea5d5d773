#include "emit/emit.h"

#include "base/text.h"
#include "emit/blocks.h"
#include "emit/interface.h"
#include "ir/rewrite.h"

namespace wrinkle {
namespace {

void write_function_form(const EmitAnalysis& analysis, const EmitOptions& options, Interface& face,
                         Shader& shader) {
    const Language& language = options.target->language();
    assign_bindings(options, face.reflection);
    set_resource_uses(analysis, language, face);
    Text text = reserve_text(analysis, options.max_bytes);
    std::string title = title_of(analysis.module(), face.reflection);
    if (analysis.implicit) title += " Call in uniform control flow.";
    text.line(0, title);
    write_precision(*options.target, text);
    write_structs(language, face.reflection, text);
    write_uniforms(analysis.module(), language, face.reflection, text);
    write_functions(analysis, face, *options.target, text);
    shader.source = std::move(text.text);
    face.reflection.lines = std::move(text.nodes);
}

bool refused(const Module& module, const EmitOptions& options, Shader& shader) {
    if (!supports(*options.target, options.form)) {
        const bool pair = options.form == Form::function;
        shader.problems.push_back({RuleId::target, 0,
                                   std::string(options.target->label) + " is only written as " +
                                       (pair ? "a complete pair" : "a function"),
                                   pair ? "the form 'shader'" : "the form 'function'"});
    }
    if (options.form == Form::shader && options.differentials != Differentials::screen)
        shader.problems.push_back({RuleId::target, 0,
                                   "the shader form takes its differentials from the screen",
                                   "differentials 'screen', or the form 'function'"});
    for (const ModuleOutput& output : module.outputs)
        if (output.value == poison)
            shader.problems.push_back({RuleId::target, 0,
                                       "the output '" + output.name + "' has no value",
                                       "an earlier problem names the reason"});
    if (options.bare_result && module.outputs.size() > 1)
        shader.problems.push_back(
            {RuleId::target, 0, "a function without a struct returns one output", ""});
    if (module.outputs.empty())
        shader.problems.push_back(
            {RuleId::no_output, 0, "the graph has no outputs", "an entry in \"outputs\""});
    return !shader.problems.empty();
}

void write_texts(const Module& module, const EmitOptions& options, Shader& shader) {
    const EmitAnalysis analysis(module, options.target->language(),
                                options.differentials == Differentials::given);
    Interface face = make_interface(analysis, options);
    if (options.form == Form::function)
        write_function_form(analysis, options, face, shader);
    else
        write_shader_form(analysis, options, face, shader);
    shader.reflection = std::move(face.reflection);
}

}  // namespace

std::string material_name(const std::filesystem::path& file) {
    return file == "-" ? "stdin" : identifier(file.stem().string());
}

Shader emit(const Module& module, const EmitOptions& options) {
    Shader shader;
    if (refused(module, options, shader)) return shader;
    try {
        if (options.target->language().has_mod || !module.has(Op::mod_))
            write_texts(module, options, shader);
        else
            write_texts(without_mod(Module(module)), options, shader);
    } catch (const OverLimit& over) {
        shader = {};
        // Lines of a function that several nodes share have no node.
        const uint32_t node = over.node != 0 ? over.node : module.origin[module.outputs[0].value];
        shader.problems.push_back({RuleId::over_limit, node, over.message, over.expected});
        shader.over_limit = true;
    }
    return shader;
}

}  // namespace wrinkle

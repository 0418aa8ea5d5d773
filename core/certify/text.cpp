#include "base/text.h"
#include "certify/checks.h"
#include "certify/compare.h"
#include "gpu/program.h"
#include "graph/write.h"
#include "ir/inspect.h"
#include "registry/plugin_code.h"

namespace wrinkle::certify {
namespace {

constexpr const char* pure =
    "build() may look at nothing but its ports: no statics that change, no clock, no addresses, no "
    "files";

// Outputs of a shader that every driver can draw.
constexpr size_t most_draw_buffers = 8;

// Emits the module for each target that is text, in each form that takes its differentials; a
// shader has the first outputs only.
std::vector<Shader> all_texts(const Module& module, bool given) {
    std::vector<Shader> texts;
    for (const Target& target : targets())
        for (const Form form : {Form::function, Form::shader}) {
            if (given && form == Form::shader) continue;
            if (!supports(target, form) || is_binary(target)) continue;
            EmitOptions options;
            options.target = &target;
            options.form = form;
            options.differentials = given ? Differentials::given : Differentials::screen;
            options.name = "subject";
            Module emitted = module;
            if (form == Form::shader && emitted.outputs.size() > most_draw_buffers)
                emitted.outputs.resize(most_draw_buffers);
            texts.push_back(emit(emitted, options));
        }
    return texts;
}

// Returns the driver's log for a complete pair in the first target's language (desktop GLSL); "" if
// the driver accepts it, or for another target, and for the function form.
std::string driver_errors(const Shader& shader) {
    if (shader.fragment.empty()) return {};
    if (shader.reflection.target != targets().front().name) return {};
    std::string log;
    gpu::Program::link(shader.vertex, shader.fragment, {}, log);
    return log;
}

std::string text_of(const Module& module) {
    return print(module) + given_text(module).source;
}

class TextCheck {
public:
    TextCheck(const NodeType& type, const CertifyContext& context, Report& report)
        : type_(type), context_(context), report_(report) {}

    void run(Inputs inputs) {
        const Subject subject = compile_harness(type_, inputs, 3, context_);
        if (!subject.compiled.ok)
            return add("text", "no graph around it compiles: " + subject.problem,
                       "the smallest one is shown; 'wrinkle check' says more", subject);
        valid(subject);
        if (deterministic(subject)) round_trip(subject);
    }

private:
    void add(const char* check, std::string message, std::string remedy, const Subject& subject) {
        report_.add({check, "", std::move(message), std::move(remedy), subject.text});
    }

    void valid(const Subject& subject) {
        for (const bool uniform : {false, true})
            for (const bool given : {false, true}) {
                Diagnostics diagnostics;
                const Compiled compiled =
                    compile(subject.project, context_, {uniform, given}, diagnostics);
                if (!compiled.ok) {
                    const std::string why = diagnostics.list().front().message;
                    add("text", "it does not compile: " + why, "", subject);
                    continue;
                }
                for (const Shader& shader : all_texts(compiled.module, given))
                    valid(shader, subject);
            }
    }

    void valid(const Shader& shader, const Subject& subject) {
        for (const Problem& problem : shader.problems)
            add("text", "it has no text: " + problem.message, "", subject);
        if (!shader.problems.empty()) return;
        std::string errors = context_.text_errors ? context_.text_errors(shader) : "";
        if (errors.empty() && context_.gpu) errors = driver_errors(shader);
        if (!errors.empty())
            add("text", "the generated text is refused: " + errors,
                "this is a fault of Wrinkle: please report it with the graph", subject);
    }

    bool deterministic(const Subject& subject) {
        Diagnostics diagnostics;
        if (type_.code) type_.code->toggle_second_run();
        const Compiled again = compile(subject.project, context_, {}, diagnostics);
        const std::string difference =
            again.ok ? text_difference(text_of(subject.compiled.module), text_of(again.module))
                     : diagnostics.list().front().message;
        if (difference.empty()) return true;
        add("deterministic", "built a second time it differs: " + difference, pure, subject);
        return false;
    }

    void round_trip(const Subject& subject) {
        Diagnostics diagnostics;
        const std::string canonical = canonical_text(subject.project.top());
        const Project project = project_of(canonical, context_, diagnostics);
        const std::string written = canonical_text(project.top());
        const Compiled again = compile(project, context_, {}, diagnostics);
        std::string difference = text_difference(canonical, written);
        if (difference.empty() && !again.ok) difference = diagnostics.list().front().message;
        if (difference.empty())
            difference = text_difference(text_of(subject.compiled.module), text_of(again.module));
        if (!difference.empty())
            add("round_trip", "read back from its file the graph differs: " + difference, pure,
                subject);
    }

    const NodeType& type_;
    const CertifyContext& context_;
    Report& report_;
};

}  // namespace

void check_text(const NodeType& type, const CertifyContext& context, Report& report) {
    TextCheck check(type, context, report);
    for (const Inputs inputs : {Inputs::defaults, Inputs::numbers, Inputs::wires, Inputs::mixed})
        check.run(inputs);
}

}  // namespace wrinkle::certify

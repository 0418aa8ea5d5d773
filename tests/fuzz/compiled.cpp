#include "fuzz/compiled.h"

#include "cpu/evaluate.h"
#include "emit/emit.h"
#include "graph/subgraph.h"
#include "lower/material.h"
#include "nodes/all.h"

namespace wrinkle::fuzz {

Registry with_built_in_nodes() {
    Registry registry;
    Diagnostics ignored;
    registry.add_plugin(built_in_nodes(), Registry::built_in, ignored);
    return registry;
}

std::string wrong_with_compiled(const Document& document, const Registry& registry,
                                bool must_compile) {
    Diagnostics diagnostics;
    const Project project = load_project(document, WRINKLE_SOURCE_DIR "/graphs", {}, diagnostics);
    MaterialOptions options;
    const Compiled for_text = compile_material(project, registry, options, diagnostics);
    if (for_text.ok == diagnostics.has_errors()) return "an error without a word, or with success";
    if (!for_text.ok) return must_compile ? to_text(diagnostics) : "";
    const Shader shader = emit(for_text.module, {});
    if (shader.source.empty() == shader.problems.empty()) return "neither a text nor a problem";

    options.given_differentials = true;
    const Compiled for_cpu = compile_material(project, registry, options, diagnostics);
    if (for_cpu.ok == diagnostics.has_errors()) return "an error without a word, or with success";
    if (!for_cpu.ok) return "";
    std::string why;
    const Program program = compile_program(for_cpu.module, why);
    if (why.empty() && program.outputs.size() != for_cpu.module.outputs.size())
        return "a program without the graph's outputs";
    return "";
}

}  // namespace wrinkle::fuzz

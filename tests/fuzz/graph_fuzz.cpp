// Untouched bytes come back, every problem has a line, canonical text of what had no problem has
// none and is a fixed point, and what has no error compiles.
#include "fuzz/fuzz.h"
#include "glsl/emit.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "lower/material.h"
#include "nodes/all.h"

namespace wrinkle::fuzz {
namespace {

const Registry& registry() {
    static const Registry made = [] {
        Registry registry;
        Diagnostics ignored;
        registry.add_plugin(built_in_nodes(), Registry::built_in, ignored);
        return registry;
    }();
    return made;
}

std::string compiled(const Document& document) {
    Diagnostics diagnostics;
    const Project project = load_project(document, WRINKLE_SOURCE_DIR "/graphs", {}, diagnostics);
    const Compiled material = compile_material(project, registry(), {}, diagnostics);
    if (material.ok == diagnostics.has_errors()) return "an error without a word, or with success";
    if (!material.ok) return "";
    const Shader shader = emit(material.module, {});

    return shader.source.empty() == shader.problems.empty() ? "neither a text nor a problem" : "";
}

std::string canonical(const Document& document) {
    const std::string text = canonical_text(document);
    Diagnostics diagnostics;
    const Document again = read_document(text, "again.json", diagnostics);
    if (diagnostics.has_errors()) return "the canonical text has " + to_text(diagnostics);
    return canonical_text(again) == text ? "" : "the canonical text is no fixed point";
}

}  // namespace

std::string graph(std::string_view bytes) {
    const std::string text(bytes);
    Diagnostics diagnostics;
    const Document document = read_document(text, "fuzz.json", diagnostics);
    if (write_document(document) != text) return "the bytes did not come back";
    report_unknown(document, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.list())
        if (diagnostic.where.line == 0) return "no line: " + to_text(diagnostic);
    if (!document.nodes.empty()) {
        const Document renamed = rename_node(document, document.nodes[0]->id, "renamed");
        canonical_text(remove_node(renamed, "renamed"));
    }
    canonical_text(document);
    if (diagnostics.has_errors()) return "";
    const std::string wrong = canonical(document);
    return wrong.empty() ? compiled(document) : wrong;
}

}  // namespace wrinkle::fuzz

// Fuzz target: an unedited document is written back byte by byte, every problem has a line, the
// canonical text of a graph without problems has none and is a fixed point, and a graph without
// errors compiles.
#include "fuzz/compiled.h"
#include "fuzz/fuzz.h"
#include "graph/edit.h"
#include "graph/read.h"
#include "graph/write.h"

namespace wrinkle::fuzz {
namespace {

const Registry& registry() {
    static const Registry made = with_built_in_nodes();
    return made;
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
    return wrong.empty() ? wrong_with_compiled(document, registry(), false) : wrong;
}

}  // namespace wrinkle::fuzz

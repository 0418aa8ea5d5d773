// Any bytes as a graph: nothing crashes, untouched bytes come back, every problem has a line, and
// canonical text of what had no problem has none and is a fixed point.
#include <cstdlib>

#include "graph/edit.h"
#include "graph/read.h"
#include "graph/write.h"

namespace {

void require(bool holds) {
    if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    using namespace wrinkle;
    const std::string text(reinterpret_cast<const char*>(data), size);
    Diagnostics diagnostics;
    const Document document = read_document(text, "fuzz.json", diagnostics);
    require(write_document(document) == text);
    report_unknown(document, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.list())
        require(diagnostic.where.line > 0);
    const std::string canonical = canonical_text(document);
    if (!diagnostics.has_errors()) {
        const Document again = read_document(canonical, "again.json", diagnostics);
        require(!diagnostics.has_errors());
        require(canonical_text(again) == canonical);
    }
    if (!document.nodes.empty()) {
        const Document renamed = rename_node(document, document.nodes[0]->id, "renamed");
        canonical_text(remove_node(renamed, "renamed"));
    }
    return 0;
}

#include "compile/double_sided.h"

namespace wrinkle {

void follow_double_sided(Document& document, const std::string& mesh, Diagnostics& diagnostics) {
    const bool is_written =
        document.source.is(json::Kind::object) && document.source.has("back_faces");
    if (is_written || document.back_faces != BackFaces::mirror) return;
    document.back_faces = BackFaces::flip;
    Diagnostic said;
    said.severity = Severity::warning;
    said.where.file = mesh;
    said.message = "a material is doubleSided, so back faces are drawn by the rule 'flip'";
    said.expected = "\"back_faces\" in the graph chooses the rule";
    diagnostics.add(std::move(said));
}

}  // namespace wrinkle

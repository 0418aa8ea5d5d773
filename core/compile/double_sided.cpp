#include "compile/double_sided.h"

#include "base/file_problem.h"

namespace wrinkle {

void follow_double_sided(Document& document, const std::string& mesh, Diagnostics& diagnostics) {
    if (document.back_faces) return;
    document.back_faces = BackFaces::flip;
    diagnostics.add(
        file_problem(Severity::warning, mesh,
                     "a material is doubleSided, so back faces are drawn by the rule 'flip'",
                     "\"back_faces\" in the graph chooses the rule"));
}

}  // namespace wrinkle

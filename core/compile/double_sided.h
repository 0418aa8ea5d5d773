// Back-face rule of glTF double-sided materials: seen from behind, a bump is a dent.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "graph/document.h"

namespace wrinkle {

// Call when drawing on a mesh with a double-sided material: if the graph does not set "back_faces",
// sets the rule `flip` and reports a warning at `mesh`.
void follow_double_sided(Document& document, const std::string& mesh, Diagnostics& diagnostics);

}  // namespace wrinkle

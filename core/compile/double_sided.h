// glTF defines a double-sided material so: seen from behind, a bump is a dent.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "graph/document.h"

namespace wrinkle {

// For drawing on a mesh with such a material: a graph that does not choose its "back_faces" gets
// the rule `flip`, and a warning at `mesh` says so.
void follow_double_sided(Document& document, const std::string& mesh, Diagnostics& diagnostics);

}  // namespace wrinkle

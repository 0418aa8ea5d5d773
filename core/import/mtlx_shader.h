// Shading models of MaterialX as standard outputs (docs/outputs.md).
#pragma once

#include "import/mtlx_importer.h"

namespace wrinkle::materialx {

// Returns true for a category that import_shader() knows.
bool is_shader(std::string_view category);

// Sets the outputs of the graph. Inputs without an output are reported unless they are neutral.
void import_shader(Importer& importer, NodeKey shader);
void import_displacement(Importer& importer, NodeKey displacement);

}  // namespace wrinkle::materialx

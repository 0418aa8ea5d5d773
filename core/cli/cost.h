// What `wrinkle compile` says of a shader's cost.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "glsl/reflection.h"

namespace wrinkle::cli {

// More images than every machine of the targets has units for: a warning that names them, with
// `strict` an error.
void judge_texture_units(const Reflection& reflection, const std::string& file, bool strict,
                         Diagnostics& diagnostics);

}  // namespace wrinkle::cli

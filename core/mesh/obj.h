// Wavefront OBJ text; what is read of it and how is said in mesh/load.h.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mesh/load.h"

namespace wrinkle {

// The mesh as the file has it: normals of corners without one are zero. `file` is for messages.
std::optional<Mesh> read_obj(std::string_view text, const std::string& file,
                             const MeshLimits& limits, Diagnostics& diagnostics);

}  // namespace wrinkle

// Reader for Wavefront OBJ; mesh/load.h lists the supported statements.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mesh/load.h"

namespace wrinkle {

// Returns the mesh as stored; normals of corners without one are zero. `file` is used in messages.
// Returns std::nullopt and appends diagnostics on failure.
std::optional<Mesh> read_obj(std::string_view text, const std::string& file,
                             const MeshLimits& limits, Diagnostics& diagnostics);

}  // namespace wrinkle

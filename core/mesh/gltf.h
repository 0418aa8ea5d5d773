// Reader for glTF 2.0; mesh/load.h lists the supported features.
#pragma once

#include <optional>
#include <string_view>

#include "mesh/load.h"

namespace wrinkle {

// Returns the triangles of the default scene with normals on every primitive, and tangents on those
// that have uv0. Returns std::nullopt and appends diagnostics on failure.
std::optional<Mesh> read_gltf(std::string_view bytes, const std::filesystem::path& path,
                              const MeshFileOptions& options, Diagnostics& diagnostics);

}  // namespace wrinkle

// glTF 2.0; what is read of it and how is said in mesh/load.h.
#pragma once

#include <optional>
#include <string_view>

#include "mesh/load.h"

namespace wrinkle {

// The triangles of the default scene; every primitive has normals, and tangents where it has uv0.
std::optional<Mesh> read_gltf(std::string_view bytes, const std::filesystem::path& path,
                              const MeshFileOptions& options, Diagnostics& diagnostics);

}  // namespace wrinkle

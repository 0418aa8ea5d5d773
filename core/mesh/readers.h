// Readers of the two mesh file formats, for load_mesh(); mesh/load.h lists the supported features.
//
// The OBJ reader is written by hand because tinyobjloader, the usual library, reads a damaged
// number as 0 and does not report line and column.
// The glTF reader uses tinygltf for JSON, buffers and data URIs. By hand, as the library does
// not offer them: range checks of accessors, node transforms, strips and fans, file access rules.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/load.h"

namespace wrinkle {

// Returns the mesh as stored; normals of corners without one are zero. `file` is used in messages.
// Returns std::nullopt and appends diagnostics on failure.
std::optional<Mesh> read_obj(std::string_view text, const std::string& file,
                             const MeshLimits& limits, Diagnostics& diagnostics);

// Returns the triangles of the default scene with normals on every primitive, and tangents on those
// that have uv0. Returns std::nullopt and appends diagnostics on failure.
std::optional<Mesh> read_gltf(std::string_view bytes, const std::filesystem::path& path,
                              const MeshFileOptions& options, Diagnostics& diagnostics);

// Triangulates a polygon of an OBJ file: appends three of `corners` per triangle, n - 2 triangles,
// with the orientation of the polygon. positions[i] belongs to corners[i]. Convex polygons, and
// concave ones of more than 256 corners, become a fan of the first corner; others are ear-clipped
// in the plane of their mean normal. Polygons that cross themselves or have no area also yield
// n - 2 triangles.
void append_triangles(std::span<const glm::vec3> positions, std::span<const uint32_t> corners,
                      std::vector<uint32_t>& indices);

}  // namespace wrinkle

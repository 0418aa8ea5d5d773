// Mesh files: Wavefront OBJ and glTF 2.0 (.gltf with its .bin files or data URIs, and .glb).
//
// The first bytes decide the format: "glTF" is a .glb, '{' a .gltf, anything else an OBJ. The
// result is one mesh in object space with finite values, unit normals and, where it has uv0,
// tangents:
//
//   OBJ   v (with r g b behind x y z: color0), vt, vn, f; all objects and groups become one mesh.
//         Other statements are skipped, materials too.
//   glTF  The triangles (lists, strips, fans) of the default scene, every node's mesh in the place
//         its transform gives it, so object space is the scene's. TEXCOORD_0 to 3, COLOR_0, sparse
//         and quantised accessors. Skins and morph targets stay in the pose that is stored. v is
//         turned over, v' = 1 - v, and tangent.w is kept. A primitive's uv sets go through the
//         KHR_texture_transform of its material: of the first texture that reads a set, in the
//         order normal, base colour, metallic-roughness, occlusion, emissive. Its tangents are made
//         anew where that transform turns or mirrors uv0. Images are never read.
//
// Faces of more than three corners are cut into triangles. Where primitives or faces differ in
// attributes the mesh has them all: a missing uv is (0, 0), a missing colour white. Missing
// normals, and those that are zero or no numbers, become smooth ones (mean over the corners that
// share a position, weighted by angle); missing tangents are made (mesh/tangents.h). Faces without
// area and edges of more than two faces are kept; they are drawn as they are.
//
// Errors name the file (an OBJ's line and column), what was found and what would help: unreadable
// or truncated files, indices out of range, positions, uvs or colours that are no finite numbers,
// coordinates beyond 1e15, nothing to draw, external files that are neither below the mesh's folder
// nor below `root`, extensions that are required and unknown, files over the limits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/diagnostics.h"
#include "base/limits.h"
#include "mesh/mesh.h"

namespace wrinkle {

struct MeshLimits {
    uint64_t max_bytes = limit_of(Limit::mesh_bytes);
    uint64_t max_corners = limit_of(Limit::mesh_corners);
};

struct MeshFileOptions {
    std::filesystem::path root;  // "": the mesh's folder alone
    MeshLimits limits;
    std::vector<std::filesystem::path>* read = nullptr;  // takes the external files too
    bool* double_sided = nullptr;  // takes whether a glTF's material is `doubleSided`
};

std::optional<Mesh> load_mesh(const std::filesystem::path& path, const MeshFileOptions& options,
                              Diagnostics& diagnostics);

// The same for bytes in memory; `path` names them in messages, external files lie beside it.
std::optional<Mesh> load_mesh_bytes(std::string_view bytes, const std::filesystem::path& path,
                                    const MeshFileOptions& options, Diagnostics& diagnostics);

}  // namespace wrinkle

// Loads mesh files: Wavefront OBJ and glTF 2.0 (.gltf with .bin files or data URIs, and .glb).
//
// The first bytes select the format: "glTF" is a .glb, '{' a .gltf, anything else an OBJ. The
// result is one mesh in object space with finite values, unit normals and, if it has uv0, tangents.
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
    std::filesystem::path root;  // "": only the mesh's folder is allowed
    MeshLimits limits;
    std::vector<std::filesystem::path>* read = nullptr;  // output: paths of the external files
    bool* double_sided = nullptr;  // output: a used glTF material is `doubleSided`
};

//   OBJ   v (optional r g b after x y z: color0), vt, vn, f. All objects and groups form one mesh.
//         Other statements, including materials, are skipped.
//   glTF  Triangles (lists, strips, fans) of the default scene, transformed by their nodes: object
//         space is scene space. TEXCOORD_0 to 3, COLOR_0, sparse and quantised accessors.
//         Skins and morph targets stay in the stored pose. v is flipped, v' = 1 - v; tangent.w is
//         unchanged. The uv sets of a primitive are transformed by the KHR_texture_transform of its
//         material: that of the first texture that reads a set, in the order normal, base color,
//         metallic-roughness, occlusion, emissive. Tangents are generated again if that transform
//         rotates or mirrors uv0. Images are not read.
//
// Faces of more than three corners are triangulated. If primitives or faces have different
// attributes, the mesh has all of them: a missing uv is (0, 0), a missing color white. Missing,
// zero and non-finite normals are replaced by smooth ones (mean over the corners that share a
// position, weighted by angle); missing tangents are generated (mesh/vertex_frames.h). Faces
// without area and edges of more than two faces are retained and drawn.
//
// Errors name the file (for an OBJ also line and column), the problem and a hint. Causes:
// unreadable or truncated files, indices out of range, non-finite positions, uvs or colors,
// coordinates beyond 1e15, nothing to draw, external files outside both the mesh's folder and
// `root`, unknown required extensions, files over the limits.
std::optional<Mesh> load_mesh(const std::filesystem::path& path, const MeshFileOptions& options,
                              Diagnostics& diagnostics);

// Loads from memory. `path` names the mesh in messages; external files are relative to its folder.
std::optional<Mesh> load_mesh_bytes(std::string_view bytes, const std::filesystem::path& path,
                                    const MeshFileOptions& options, Diagnostics& diagnostics);

}  // namespace wrinkle

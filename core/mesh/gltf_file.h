// Parses a glTF file into a tinygltf model. Safe for untrusted files: nesting, lengths and external
// files are checked before and during parsing, images are not read, no exception leaves.
#pragma once

#include <tiny_gltf.h>

#include <string_view>

#include "mesh/load.h"

namespace wrinkle {

// Returns false and appends one error that names the file on failure.
bool read_gltf_file(std::string_view bytes, const std::filesystem::path& path,
                    const MeshFileOptions& options, tinygltf::Model& model,
                    Diagnostics& diagnostics);

}  // namespace wrinkle

// A glTF file as tinygltf's model, read so that no file can do harm: nesting, lengths and external
// files are checked before and while the library reads, images are left alone, nothing is thrown.
#pragma once

#include <tiny_gltf.h>

#include <string_view>

#include "mesh/load.h"

namespace wrinkle {

// False with one error that names the file.
bool read_gltf_file(std::string_view bytes, const std::filesystem::path& path,
                    const MeshFileOptions& options, tinygltf::Model& model,
                    Diagnostics& diagnostics);

}  // namespace wrinkle

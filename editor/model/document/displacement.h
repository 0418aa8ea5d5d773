// A finely subdivided mesh, displaced by a graph's output `displacement`.
#pragma once

#include <optional>
#include <vector>

#include "base/diagnostics.h"
#include "cpu/evaluate.h"
#include "cpu/texture_store.h"
#include "ir/side_tables.h"
#include "mesh/mesh.h"

namespace wrinkle::editor {

struct Displacement {
    Program program;  // output 0 is the height, in length units of object space
    std::vector<Resource> images;
};

// Reads images missing in `textures`. Returns std::nullopt with the reason in `problems` on
// failure.
std::optional<Mesh> displaced(const Mesh& still, const Displacement& displacement,
                              TextureStore& textures, Diagnostics& problems);

}  // namespace wrinkle::editor

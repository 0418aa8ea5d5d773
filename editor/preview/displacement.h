// A mesh in fine triangles, moved by a graph's output `displacement`.
#pragma once

#include <optional>
#include <vector>

#include "base/diagnostics.h"
#include "cpu/evaluate.h"
#include "cpu/texture_store.h"
#include "ir/module.h"
#include "mesh/mesh.h"

namespace wrinkle::editor {

struct Displacement {
    Program program;  // output 0 is the height, in length units of object space
    std::vector<Resource> images;
};

// Reads what `textures` lacks. Nothing, with the reason, when it cannot be done.
std::optional<Mesh> displaced(const Mesh& still, const Displacement& displacement,
                              TextureStore& textures, Diagnostics& problems);

}  // namespace wrinkle::editor

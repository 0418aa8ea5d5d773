// Loads the images that a module samples, for evaluation, baking and rendering.
#pragma once

#include "cpu/texture_store.h"
#include "lower/material.h"

namespace wrinkle {

// Reads the images that the module samples. A problem is reported at the first node that reads the
// image; a file that fails is reported only once.
void read_textures(TextureStore& textures, const Compiled& compiled, const Project& project,
                   Diagnostics& diagnostics);

}  // namespace wrinkle

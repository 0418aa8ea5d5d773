// The images of a module as pixels, for what computes numbers or pictures.
#pragma once

#include "cpu/texture_store.h"
#include "lower/material.h"

namespace wrinkle {

// Reads what the module samples. A problem is reported at the first node that reads the image; a
// file that failed once is reported once.
void read_textures(TextureStore& textures, const Compiled& compiled, const Project& project,
                   Diagnostics& diagnostics);

}  // namespace wrinkle

// Texels of a texture: the values that a sampler filters.
//
// Images of encoding srgb are decoded (IEC 61966-2-1) before mips are built, as GPUs decode sRGB
// formats before they filter. Decoded values are floats, also of 8-bit files: linear light needs
// more than 8 bits. Alpha is unchanged; negative values of float files use the linear segment.
#pragma once

#include <compare>
#include <filesystem>
#include <optional>
#include <string>

#include "base/texture_options.h"
#include "image/load.h"
#include "image/mips.h"

namespace wrinkle {

// Identity of a texture's texels. A file that is read with two encodings may have two of them.
struct TexelSource {
    std::string file;
    bool srgb = false;  // decoded from sRGB

    friend auto operator<=>(const TexelSource&, const TexelSource&) = default;
};

// For Resource (ir/side_tables.h) and SamplerInfo (emit/reflection.h).
template <class Sampled>
TexelSource texels_of(const Sampled& image) {
    return {image.file, image.options.decodes_texels()};
}

// Precondition: the values of an integer `source` are steps of its type, as from load_image().
void decode_srgb(Image& image);

// Errors as load_image().
std::optional<MipChain> load_texels(const TexelSource& source, const ImageLimits& limits,
                                    Diagnostics& diagnostics);

}  // namespace wrinkle

// Texels of a map to be written: the numbers that mip levels average, and their encoding in a file.
#pragma once

#include <string>
#include <vector>

#include "image/writer.h"
#include "maps/convert.h"
#include "maps/map.h"

namespace wrinkle::maps {

// Encoding of integers: value = offset + scale t. Floats hold the value.
struct Stored {
    float scale = 1;
    float offset = 0;
};

// Returns the averaged numbers per texel: height 1, normal and derivative 2, moments 3, slopes 6.
uint32_t mean_channels(Kind kind);

// A derivative map has R and G, and a constant B unless the format supports two channels (`pairs`).
std::vector<std::string> file_channel_names(const Target& target, bool pairs);

// Writes one row of the averaged numbers: the height, or du and dv, or values computed from these.
void mean_row(const Rows& rows, const Target& target, uint32_t y, float* out);

// Encodes `count` texels for a file with `channels` channels.
void encode(const Target& target, const Stored& stored, const float* means, size_t count,
            uint32_t channels, float* out);

}  // namespace wrinkle::maps

// The texels of a map to be written: first the numbers that mip levels are means of, then what a
// file holds.
#pragma once

#include <string>
#include <vector>

#include "image/writer.h"
#include "maps/convert.h"
#include "maps/map.h"

namespace wrinkle::maps {

// How integers stand for values: value = offset + scale t. Floats are values.
struct Stored {
    float scale = 1;
    float offset = 0;
};

// Height 1, normal and derivative 2, moments 3, slopes 6.
uint32_t mean_channels(Kind kind);

// Of a derivative R and G, and B, which is flat, where a format holds no pairs.
std::vector<std::string> file_channel_names(const Target& target, bool pairs);

// One row of the numbers that are averaged: the height, or du and dv, or what is made of them.
void mean_row(const Rows& rows, const Target& target, uint32_t y, float* out);

// `count` texels as a file of so many channels holds them.
void encode(const Target& target, const Stored& stored, const float* means, size_t count,
            uint32_t channels, float* out);
bool is_plain(const Target& target, uint32_t channels);  // encode() would change nothing

}  // namespace wrinkle::maps

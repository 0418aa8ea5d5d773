// The statistics that lint decides by. Sums run in double, row by row, on one thread: equal numbers
// everywhere.
#pragma once

#include <array>

#include "image/image.h"
#include "maps/map.h"

namespace wrinkle::maps {

inline constexpr double u8_step = 1.0 / 255;  // of stored numbers in 8 bits

// Of pictures with three channels; vectors are 2t - 1. Black texels, where nothing was baked, are
// left out of all but their own share.
struct VectorMeasures {
    double empty = 0;     // share that is black
    double unit = 0;      // share of texels of length 1 within 0.1
    double downward = 0;  // share that points down by more than 0.1
    double gray = 0;      // share whose channels are equal within 2.5 / 255
    std::array<double, 3> mean = {};
    double blue_spread = 0;  // highest less lowest
    double signed_z = 0;     // rms of blue less (1 + z) / 2, with z made from red and green
    double unsigned_z = 0;   // rms of blue less z
    double between_z = 0;    // rms of the one less the other: how far they can be told apart
};
VectorMeasures measure_vectors(const Image& image);

// Slopes as gl has them, differentiated once more by the same filter. Spikes count as slope 4.
struct CurlMeasures {
    double gl = 0;           // rms of du/dv - dv/du
    double dx = 0;           // the same with green turned
    double correlation = 0;  // of the two terms, -1 to 1; 0 where there is no slope
};
CurlMeasures measure_curl(const Image& image, bool made_z, Wrap wrap);

// Of the texels that are not flat (127 or 128 in red and green), in steps of 1/255 from 127.5.
struct OffsetMeasures {
    double red = 0, green = 0;
    double tilted = 0;  // their share
};
OffsetMeasures measure_offset(const Image& image);

// Of one channel.
struct StepMeasures {
    double still = 0;         // share of neighbours (to the right, above) that are equal
    double one = 0;           // share that is one level apart
    size_t levels = 0;        // different values
    bool eight_bits = false;  // a deeper file whose values are all those of 8 bits
};
StepMeasures measure_steps(const Image& image, uint32_t channel);

// The mean step over the border against the steps inside, of the first `channels` channels.
struct SeamMeasures {
    double border = 0;
    double inside = 0;  // that 99 of 100 columns (or rows) stay below
};
SeamMeasures measure_seam(const Image& image, uint32_t channels, bool across_u);

}  // namespace wrinkle::maps

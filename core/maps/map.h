// Maps of a bump, and how their texels are read: one picture as a height or as slopes.
//
// Slopes are changes of the height along u (to the right) and v (up; green of a `gl` normal map),
// in units of height PER TEXEL. A slope map of a height h has, per texel, the 3x3 Sobel filter / 8:
// (2 h[+1] + neighbours above and below) minus the same at -1. It is exact for planes, and the mean
// of the slopes of a repeated height is zero. What lies beyond the border is the picture again
// (repeat) or the border's own height, as a sampler reads it (clamp: an even extension, so the
// slope across a border is half of that to its only neighbour).
//
//   height      the stored value; colours give the mean of red, green and blue
//   normal      m = 2t - 1, slopes -m.xy / z, z = max(|m.z|, max(|m.x|, |m.y|) / 128, 1e-6), the
//               clamps of docs/surface-gradient.md; a picture of two channels has the z that makes
//               m unit. `dx` maps have their green turned
//   derivative  slopes; integer files hold t of slope = scale (2t - 1), float files the slope
//   slopes      six channels, as OpenImageIO's --bumpslopes: height, dh/ds, dh/dt, their squares,
//               their product; t runs DOWN, so dh/dt = -dh/dv. Its mips are means of all six, so a
//               coarse level still knows how rough what it stands for is
//   moments     the squares of the slopes along u and v, and their product, v up: what the node
//               slope_moments_map reads beside a derivative map
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/texture_options.h"
#include "image/image.h"

namespace wrinkle::maps {

enum class Kind : uint8_t { height, normal, derivative, slopes, moments };
enum class Green : uint8_t { gl, dx };  // which way a normal map's green points: up v, or down
enum class Per : uint8_t { texel, uv };

// How a picture is to be read.
struct Source {
    const Image* image = nullptr;
    Kind kind = Kind::height;  // neither slopes nor moments
    Green green = Green::gl;
    Per per = Per::texel;     // of derivatives
    Wrap wrap = Wrap::clamp;  // or repeat
    float factor = 1;         // of the height, and so of the slopes
    float offset = 0;         // added to heights after that
    float stored_scale = 1;   // of derivatives in integer files
    float texel_width = 1;    // size of a texel in units of height: slopes are divided by it
    float texel_height = 1;
};

// What the row of a normal map says of slopes: `channels` of each texel count, which is `stride`
// numbers.
void slopes_of_normals(const float* texels, uint32_t stride, uint32_t channels, float green,
                       uint32_t count, float* du, float* dv);

// Three rows of heights, and their slopes along the middle one before they are divided by 8.
struct ThreeRows {
    const float *above, *here, *below;
};
void sobel_row(const ThreeRows& heights, uint32_t count, Wrap wrap, float* du, float* dv);

// Rows of a map, computed as they are asked for; any thread may ask for any row.
class Rows {
public:
    explicit Rows(const Source& source);

    uint32_t width() const { return source_.image->width; }
    uint32_t height() const { return source_.image->height; }
    const Source& source() const { return source_; }

    // width() values each, row 0 at the bottom.
    const float* heights(uint32_t y) const {  // null but for a picture of heights
        return heights_ ? heights_ + size_t{y} * width() : nullptr;
    }
    void slopes(uint32_t y, float* du, float* dv) const;

private:
    void sobel(uint32_t y, float* du, float* dv) const;
    void decode(uint32_t y, float* du, float* dv) const;

    Source source_;
    std::vector<float> made_;  // heights, when the picture's own values are not those
    const float* heights_ = nullptr;
};

}  // namespace wrinkle::maps

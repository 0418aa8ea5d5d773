// Bump maps and their decoding: reads an image as heights or as slopes.
//
// Slopes are derivatives of the height along u (to the right) and v (up; green of a `gl` normal
// map), in units of height PER TEXEL. The slope of a height map h is, per texel, the 3x3 Sobel
// filter / 8: (2 h[+1] + neighbours above and below) minus the same at -1. It is exact for planes,
// and the mean slope of a repeated height is zero. Texels beyond the border are those of the
// repeated image (repeat) or of the border (clamp: an even extension, so the slope across a border
// is half of that to its only neighbour).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/texture_options.h"
#include "image/image.h"

namespace wrinkle::maps {

//   height      the stored value; for colors the mean of red, green and blue
//   normal      m = 2t - 1 for the stored value t, slopes -m.xy / z, with the clamps of
//               docs/surface-gradient.md: z = max(|m.z|, max(|m.x|, |m.y|) / 128, 1e-6); for two
//               channels z is reconstructed so that m is unit. `dx` maps have green inverted
//   derivative  slopes; integer files hold t of slope = scale (2t - 1), float files the slope
//   slopes      six channels, as OpenImageIO's --bumpslopes: height, dh/ds, dh/dt, their squares,
//               their product; t runs DOWN, so dh/dt = -dh/dv. Its mips are means of all six, so a
//               coarse level retains the variance (roughness) of the slopes it covers
//   moments     the squares of the slopes along u and v, and their product, v up: the input of the
//               node slope_moments_map, used together with a derivative map
enum class Kind : uint8_t { height, normal, derivative, slopes, moments };
enum class Green : uint8_t { gl, dx };  // direction of green: up v, or down
enum class Per : uint8_t { texel, uv };

// An image and its decoding. The image must outlive the Source and its Rows.
struct Source {
    const Image* image = nullptr;
    Kind kind = Kind::height;  // except slopes and moments
    Green green = Green::gl;
    Per per = Per::texel;     // only for derivatives
    Wrap wrap = Wrap::clamp;  // or repeat
    float factor = 1;         // applied to the height, and so to slopes
    float offset = 0;         // added to heights after the factor
    float stored_scale = 1;   // for derivatives in integer files
    float texel_width = 1;    // in units of height; divides the slopes of heights
    float texel_height = 1;
};

// Decodes `count` texels of a normal map to slopes. Texels are `stride` floats apart; `channels` of
// each are used. `green` is the sign of the green channel, 1 or -1.
void slopes_of_normals(const float* texels, uint32_t stride, uint32_t channels, float green,
                       uint32_t count, float* du, float* dv);

// Multiplies `count` slopes along u by `across` and those along v by `up`.
void multiply(float* du, float across, float* dv, float up, size_t count);

// Three rows of heights. sobel_row() computes the slopes along the middle one, times 8.
struct ThreeRows {
    const float *above, *here, *below;
};
void sobel_row(const ThreeRows& heights, uint32_t count, Wrap wrap, float* du, float* dv);

// Rows of a map, decoded on request. Any thread may request any row.
class Rows {
public:
    explicit Rows(const Source& source);

    uint32_t width() const { return source_.image->width; }
    uint32_t height() const { return source_.image->height; }
    const Source& source() const { return source_; }

    // Every row has width() values; row 0 is at the bottom.
    const float* heights(uint32_t y) const {  // null except for height maps
        return heights_ ? heights_ + size_t{y} * width() : nullptr;
    }
    // Writes width() slopes to du and dv, times `factor`.
    void slopes(uint32_t y, float* du, float* dv) const;

private:
    void sobel(uint32_t y, float* du, float* dv) const;
    void decode(uint32_t y, float* du, float* dv) const;

    Source source_;
    std::vector<float> made_;  // converted heights; empty if the image can be used directly
    const float* heights_ = nullptr;
};

}  // namespace wrinkle::maps

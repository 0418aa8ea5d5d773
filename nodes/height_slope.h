// Slope of a height texture. The derivative of bilinear filtering is not usable: it jumps from
// texel to texel.
//
//   smooth       under magnification a 4x4 kernel, else three taps: DerivFromHeightMap of
//                Mikkelsen's framework. Per axis, t texels past the centre of the second of four,
//                weights ((1-t), (2-t), (1+t), t)/4 across and (-(1-t), -t, (1-t), t)/2 along;
//                fades out as the level of detail goes from 0.05 to 0.5. Eleven reads.
//   three_taps   forward differences over one texel of the current mip level; facets when magnified
//   pixel        forward differences over one pixel, as dFdx of the height gives (Mikkelsen 2010,
//                listing 2): blocky, for comparison
#pragma once

#include "wrinkle/image.h"

namespace wrinkle::nodes {

enum class HeightQuality { smooth, three_taps, pixel };
inline constexpr const char* height_qualities[] = {"smooth", "three_taps", "pixel"};
inline constexpr char height_quality_doc[] =
    "How the slope is read: smooth also close up; three taps are cheaper, with facets close up; "
    "pixel is what hardware derivatives of the height give, blocky";

// Returns dh/d(u,v) of the red channel, per uv unit.
sdk::vec2 height_slope(sdk::Image image, sdk::vec2 uv, HeightQuality quality);

// The same with given differentials of uv, for a uv that jumps from pixel to pixel.
struct Changes {
    sdk::vec2 x, y;
};
sdk::vec2 height_slope(sdk::Image image, sdk::vec2 uv, HeightQuality quality, Changes changes);

// Returns the screen differentials of the red channel in x and y, as the quality `pixel` reads it.
sdk::vec2 pixel_change(sdk::Image image, sdk::vec2 uv);

// Returns the red channel, with the slope of that quality as its derivative.
sdk::Float read_height(sdk::Image image, sdk::vec2 uv, HeightQuality quality);

}  // namespace wrinkle::nodes

// The slope of a height texture: what bilinear filtering cannot give, as its own derivative jumps
// from texel to texel.
//
//   smooth       under magnification a 4x4 kernel, else three taps: DerivFromHeightMap of
//                Mikkelsen's framework. Per axis, t texels past the centre of the second of four,
//                weights ((1-t), (2-t), (1+t), t)/4 across and (-(1-t), -t, (1-t), t)/2 along;
//                fades out as the level of detail goes from 0.05 to 0.5. Eleven reads.
//   three_taps   forward differences over one texel of the level in use; facets when magnified
//   pixel        forward differences over one pixel, which is what dFdx of the height would give
//                (Mikkelsen 2010, listing 2): blocky, for comparison
#pragma once

#include "wrinkle/image.h"

namespace wrinkle::nodes {

enum class HeightQuality { smooth, three_taps, pixel };
#define HEIGHT_QUALITIES \
    { "smooth", "three_taps", "pixel" }
#define HEIGHT_QUALITY_DOC                                                                        \
    "How the slope is read: smooth also close up; three taps are cheaper, with facets close up; " \
    "pixel is what hardware derivatives of the height give, blocky"

// dh/d(u,v) of the red channel, per uv unit.
sdk::vec2 height_slope(sdk::Image image, sdk::vec2 uv, HeightQuality quality);

// The same where uv jumps from pixel to pixel: by given changes of uv to the next ones.
struct Changes {
    sdk::vec2 x, y;
};
sdk::vec2 height_slope(sdk::Image image, sdk::vec2 uv, HeightQuality quality, Changes changes);

// The change of the red channel to the next pixels, in x and y, as the quality `pixel` reads it.
sdk::vec2 pixel_change(sdk::Image image, sdk::vec2 uv);

// The red channel, its derivative the slope of that quality.
sdk::Float read_height(sdk::Image image, sdk::vec2 uv, HeightQuality quality);

}  // namespace wrinkle::nodes

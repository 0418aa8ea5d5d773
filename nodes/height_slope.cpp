#include "nodes/height_slope.h"

#include "wrinkle/region.h"

namespace wrinkle::nodes {
using namespace sdk;

namespace {

// Texels of level 0 that a pixel covers, along its longer side.
Float footprint(Image image, vec2 uv) {
    const vec2 size = image.size();
    return detach(max(length(ddx(uv) * size), length(ddy(uv) * size)));
}

vec2 three_taps(Image image, vec2 uv, Float texels) {
    const vec2 texel = max(texels, 1) / image.size();
    const Float here = image.sample(uv).x();
    const Float right = image.sample(uv + vec2(texel.x(), 0)).x();
    const Float above = image.sample(uv + vec2(0, texel.y())).x();
    return vec2(right - here, above - here) / texel;
}

// The 4x4 kernel is Sobel's over bilinear reads one texel apart: each read brings (1-t, t) of its
// two texels, and their weights (1, 2, 1)/4 and (-1, 0, 1)/2 do the rest.
vec2 smooth_slope(Image image, vec2 uv) {
    const auto slope = function("smooth_slope", [image](vec2 at, vec2 texel) {
        const auto tap = [&](int i, int j) {
            return image.sample_lod(at + vec2(i, j) * texel, 0).x();
        };
        const Float a = tap(1, 1) - tap(-1, -1), b = tap(1, -1) - tap(-1, 1);
        const Float along_u = a + b + 2 * (tap(1, 0) - tap(-1, 0));
        const Float along_v = a - b + 2 * (tap(0, 1) - tap(0, -1));
        return vec2(along_u, along_v) / (8 * texel);
    });
    return slope(uv, 1 / image.size());
}

vec2 pixel_difference(Image image, vec2 uv) {
    const vec2 x = ddx(uv), y = ddy(uv);
    const Float here = image.sample(uv).x();
    const Float change_x = image.sample(uv + detach(x)).x() - here;
    const Float change_y = image.sample(uv + detach(y)).x() - here;
    const Float det = x.x() * y.y() - x.y() * y.x();
    return vec2(divide(change_x * y.y() - change_y * x.y(), det),
                divide(change_y * x.x() - change_x * y.x(), det));
}

}  // namespace

vec2 height_slope(Image image, vec2 uv, HeightQuality quality) {
    if (quality == HeightQuality::pixel) return pixel_difference(image, uv);
    const Float texels = footprint(image, uv);
    const vec2 coarse = three_taps(image, uv, texels);
    if (quality == HeightQuality::three_taps) return coarse;
    const Float magnified = saturate((0.5 - log2(texels)) / (0.5 - 0.05));
    return mix(coarse, smooth_slope(image, uv), magnified);
}

Float read_height(Image image, vec2 uv, HeightQuality quality) {
    return with_slope(image.sample(uv).x(), uv, height_slope(image, uv, quality));
}

}  // namespace wrinkle::nodes

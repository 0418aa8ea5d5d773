#include "nodes/height_slope.h"

#include "wrinkle/region.h"

namespace wrinkle::nodes {
using namespace sdk;

namespace {

// How the picture is read: by the changes of uv between pixels, or by given ones where uv jumps.
struct Reader {
    Image image;
    Changes changes;
    bool given;

    Float at(vec2 uv) const {
        return (given ? image.sample_grad(uv, changes.x, changes.y) : image.sample(uv)).x();
    }
    // Texels of level 0 that a pixel covers, along its longer side.
    Float footprint() const {
        const vec2 size = image.size();
        return detach(max(length(changes.x * size), length(changes.y * size)));
    }
};

vec2 three_taps(const Reader& read, vec2 uv, Float texels) {
    const vec2 texel = max(texels, 1) / read.image.size();
    const Float here = read.at(uv);
    const Float right = read.at(uv + vec2(texel.x(), 0));
    const Float above = read.at(uv + vec2(0, texel.y()));
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

vec2 pixel_difference(const Reader& read, vec2 uv) {
    const auto [x, y] = read.changes;
    const Float here = read.at(uv);
    const Float change_x = read.at(uv + detach(x)) - here;
    const Float change_y = read.at(uv + detach(y)) - here;
    const Float det = x.x() * y.y() - x.y() * y.x();
    return vec2(divide(change_x * y.y() - change_y * x.y(), det),
                divide(change_y * x.x() - change_x * y.x(), det));
}

vec2 slope_of(const Reader& read, vec2 uv, HeightQuality quality) {
    if (quality == HeightQuality::pixel) return pixel_difference(read, uv);
    const Float texels = read.footprint();
    const vec2 coarse = three_taps(read, uv, texels);
    if (quality == HeightQuality::three_taps) return coarse;
    const Float magnified = saturate((0.5 - log2(texels)) / (0.5 - 0.05));
    return mix(coarse, smooth_slope(read.image, uv), magnified);
}

}  // namespace

vec2 height_slope(Image image, vec2 uv, HeightQuality quality) {
    return slope_of({image, {ddx(uv), ddy(uv)}, false}, uv, quality);
}

vec2 height_slope(Image image, vec2 uv, HeightQuality quality, Changes changes) {
    return slope_of({image, changes, true}, uv, quality);
}

Float read_height(Image image, vec2 uv, HeightQuality quality) {
    return with_slope(image.sample(uv).x(), uv, height_slope(image, uv, quality));
}

}  // namespace wrinkle::nodes

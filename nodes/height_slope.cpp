#include "nodes/height_slope.h"

#include "wrinkle/region.h"

namespace wrinkle::nodes {
using namespace sdk;

namespace {

// Reads the texture with the screen differentials of uv, or with given ones if uv jumps.
struct Reader {
    Image image;
    Changes changes;
    bool given;

    Float at(vec2 uv) const {
        return (given ? image.sample_grad(uv, changes.x, changes.y) : image.sample(uv)).x();
    }
    // Returns the texels of level 0 that a pixel covers along its longer side, at least one.
    Float footprint() const {
        const vec2 size = image.size(), x = named("texels_dx", changes.x * size);
        const vec2 y = named("texels_dy", changes.y * size);
        return named("footprint", detach(sqrt(max(max(dot(x, x), dot(y, y)), 1))));
    }
};

// Unit of a slope's run: a uv unit, or a texel of level 0.
enum class Unit { uv, texel };

vec2 three_taps(const Reader& read, vec2 uv, Float texels, Unit unit) {
    const vec2 step = named("texel_step", texels / read.image.size());
    const Float here = named("here", read.at(uv));
    const Float right = named("right", read.at(vec2(uv.x() + step.x(), uv.y())));
    const Float above = named("above", read.at(vec2(uv.x(), uv.y() + step.y())));
    const vec2 change(right - here, above - here);
    return unit == Unit::uv ? change / step : change * (1 / texels);
}

// The 4x4 kernel is a Sobel filter over bilinear reads one texel apart. Per axis, a read weights
// its two texels by (1-t, t), t as in height_slope.h; the filter weights the reads by (1, 2, 1)/4
// across and (-1, 0, 1)/2 along.
vec2 smooth_slope(Image image, vec2 uv, Unit unit) {
    const auto change = function("smooth_slope(at, texel)", [image](vec2 at, vec2 texel) {
        const auto tap = [&](const char* name, int i, int j) {
            return named(name, image.sample_lod(at + vec2(i, j) * texel, 0).x());
        };
        const Float a = named("rising", tap("upper_right", 1, 1) - tap("lower_left", -1, -1));
        const Float b = named("falling", tap("lower_right", 1, -1) - tap("upper_left", -1, 1));
        const Float along_u = a + b + 2 * (tap("right", 1, 0) - tap("left", -1, 0));
        const Float along_v = a - b + 2 * (tap("above", 0, 1) - tap("below", 0, -1));
        return vec2(along_u, along_v) * 0.125;
    });
    const vec2 size = image.size(), slope = change(uv, 1 / size);
    return unit == Unit::uv ? slope * size : slope;
}

vec2 pixel_change(const Reader& read, vec2 uv) {
    const Float here = read.at(uv);
    return {read.at(uv + detach(read.changes.x)) - here,
            read.at(uv + detach(read.changes.y)) - here};
}

vec2 pixel_difference(const Reader& read, vec2 uv) {
    const auto [x, y] = read.changes;
    const vec2 change = pixel_change(read, uv);
    const Float det = x.x() * y.y() - x.y() * y.x();
    return vec2(divide(change.x() * y.y() - change.y() * x.y(), det),
                divide(change.y() * x.x() - change.x() * y.x(), det));
}

// Slope for the qualities `smooth` and `three_taps`.
vec2 slope_of(const Reader& read, vec2 uv, HeightQuality quality, Unit unit) {
    const Float texels = read.footprint();
    const vec2 coarse = named("coarse", three_taps(read, uv, texels, unit));
    if (quality == HeightQuality::three_taps) return coarse;
    const Float magnified = named("magnified", saturate((0.5 - log2(texels)) / (0.5 - 0.05)));
    return named("slope", mix(coarse, smooth_slope(read.image, uv, unit), magnified));
}

vec2 height_slope(const Reader& read, vec2 uv, HeightQuality quality) {
    return quality == HeightQuality::pixel ? pixel_difference(read, uv)
                                           : slope_of(read, uv, quality, Unit::uv);
}

Reader implicit(Image image, vec2 uv) {
    return {image, {ddx(uv), ddy(uv)}, false};
}

}  // namespace

vec2 height_slope(Image image, vec2 uv, HeightQuality quality) {
    return height_slope(implicit(image, uv), uv, quality);
}

vec2 height_slope(Image image, vec2 uv, HeightQuality quality, Changes changes) {
    return height_slope({image, changes, true}, uv, quality);
}

vec2 pixel_change(Image image, vec2 uv) {
    return pixel_change(implicit(image, uv), uv);
}

Float read_height(Image image, vec2 uv, HeightQuality quality) {
    const Reader read = implicit(image, uv);
    const Float value = image.sample(uv).x();
    if (quality == HeightQuality::pixel) return with_slope(value, uv, pixel_difference(read, uv));
    // A slope per texel, because the footprint also needs the differentials of uv * size.
    return with_slope(value, uv * image.size(), slope_of(read, uv, quality, Unit::texel));
}

}  // namespace wrinkle::nodes

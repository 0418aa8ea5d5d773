#include "nodes/color_space.h"

namespace wrinkle::nodes {
using namespace sdk;

vec3 encoded(vec3 linear) {
    const auto component = function("srgb_encoded(x)", [](Float x) {
        return select(x <= 0.0031308, 12.92 * max(x, 0), 1.055 * pow(x, 1 / 2.4) - 0.055);
    });
    return by_components(linear, component);
}
vec3 decoded(vec3 display) {
    const auto component = function("srgb_decoded(x)", [](Float x) {
        return select(x <= 0.04045, max(x, 0) / 12.92, pow((x + 0.055) / 1.055, 2.4));
    });
    return by_components(display, component);
}

// Matrices by rows.
static vec3 product(vec3 row_0, vec3 row_1, vec3 row_2, vec3 v) {
    return {dot(row_0, v), dot(row_1, v), dot(row_2, v)};
}

vec3 to_oklab(vec3 linear) {
    const auto lab = function("to_oklab(c)", [](vec3 c) {
        const vec3 cones = named("cones", product({0.4122214708, 0.5363325363, 0.0514459929},
                                                  {0.2119034982, 0.6806995451, 0.1073969566},
                                                  {0.0883024619, 0.2817188376, 0.6299787005}, c));
        const vec3 roots = named("roots", sign(cones) * pow(abs(cones), 1.0 / 3));
        return product({0.2104542553, 0.7936177850, -0.0040720468},
                       {1.9779984951, -2.4285922050, 0.4505937099},
                       {0.0259040371, 0.7827717662, -0.8086757660}, roots);
    });
    return lab(linear);
}
vec3 from_oklab(vec3 lab) {
    const auto linear = function("from_oklab(lab)", [](vec3 lab) {
        const vec3 roots = named(
            "roots", product({1, 0.3963377774, 0.2158037573}, {1, -0.1055613458, -0.0638541728},
                             {1, -0.0894841775, -1.2914855480}, lab));
        return product({4.0767416621, -3.3077115913, 0.2309699292},
                       {-1.2684380046, 2.6097574011, -0.3413193965},
                       {-0.0041960863, -0.7034186147, 1.7076147010},
                       named("cones", roots * roots * roots));
    });
    return linear(lab);
}

vec3 to_hsv(vec3 linear) {
    const auto hsv = function("to_hsv(c)", [](vec3 c) {
        const Float most = named("most", max(max(c.x(), c.y()), c.z()));
        const Float least = named("least", min(min(c.x(), c.y()), c.z()));
        const Float range = named("range", most - least);
        const auto sector = [&](Float a, Float b, double turn) {
            return divide(a - b, 6 * range) + turn;
        };
        const Float hue = select(
            most == c.x(), sector(c.y(), c.z(), 0),
            select(most == c.y(), sector(c.z(), c.x(), 1.0 / 3), sector(c.x(), c.y(), 2.0 / 3)));
        return vec3(select(range > 0, fract(hue), 0), divide(range, most), most);
    });
    return hsv(linear);
}
vec3 from_hsv(vec3 hsv) {
    const auto linear = function("from_hsv(hsv)", [](vec3 hsv) {
        const vec3 turn = named("turn", fract(hsv.x() + vec3(0, 2.0 / 3, 1.0 / 3)));
        const vec3 pure = named("pure", saturate(abs(turn * 6 - 3) - 1));
        return hsv.z() * mix(vec3(1), pure, hsv.y());
    });
    return linear(hsv);
}

vec3 in_space(Space space, vec3 linear) {
    return space == Space::display ? encoded(linear)
           : space == Space::oklab ? to_oklab(linear)
                                   : linear;
}
vec3 from_space(Space space, vec3 color) {
    return space == Space::display ? decoded(color)
           : space == Space::oklab ? from_oklab(color)
                                   : color;
}

}  // namespace wrinkle::nodes

// Blends of two colors and of two numbers. Formulas: W3C Compositing and Blending 1, and for the
// modes that it lacks those of Photoshop.
#include <span>

#include "nodes/color_space.h"
#include "nodes/smooth.h"

namespace wrinkle::nodes {
using namespace sdk;

enum class Mode {
    normal,
    multiply,
    screen,
    overlay,
    darken,
    lighten,
    add,
    subtract,
    divide,
    difference,
    exclusion,
    hard_light,
    soft_light,
    linear_light,
    vivid_light,
    pin_light,
    hard_mix,
    color_dodge,
    color_burn,
    linear_burn,
    hue,
    saturation,
    color,
    luminosity
};

static Float screen(Float base, Float top) {
    return base + top - base * top;
}
static Float hard_light(Float base, Float top) {
    return select(top <= 0.5, 2 * base * top, screen(base, 2 * top - 1));
}
static Float soft_light(Float base, Float top) {
    const auto light = function("soft_light(base, top)", [](Float base, Float top) {
        const Float dark = base - (1 - 2 * top) * base * (1 - base);
        const Float root =
            named("root", select(base <= 0.25, ((16 * base - 12) * base + 4) * base, sqrt(base)));
        return select(top <= 0.5, dark, base + (2 * top - 1) * (root - base));
    });
    return light(base, top);
}
static Float color_dodge(Float base, Float top) {
    const Float quotient = min(divide(base, 1 - top), 1);
    return select(base <= 0, 0.0, select(top >= 1, 1.0, quotient));
}
static Float color_burn(Float base, Float top) {
    const Float quotient = 1 - min(divide(1 - base, top), 1);
    return select(base >= 1, 1.0, select(top <= 0, 0.0, quotient));
}
static Float vivid_light(Float base, Float top) {
    return select(top <= 0.5, color_burn(base, 2 * top), color_dodge(base, 2 * top - 1));
}
static Float pin_light(Float base, Float top) {
    return select(2 * top - 1 > base, 2 * top - 1, select(2 * top < base, 2 * top, base));
}

// Modes of one component.
static Float blended(Mode mode, Float base, Float top) {
    switch (mode) {
        case Mode::screen:
            return screen(base, top);
        case Mode::overlay:
            return hard_light(top, base);
        case Mode::hard_light:
            return hard_light(base, top);
        case Mode::soft_light:
            return soft_light(base, top);
        case Mode::vivid_light:
            return vivid_light(base, top);
        case Mode::pin_light:
            return pin_light(base, top);
        case Mode::color_dodge:
            return color_dodge(base, top);
        default:
            return color_burn(base, top);
    }
}

// The luminosity of W3C, which has other weights than luminance().
static Float lum(vec3 color) {
    return dot(color, vec3(0.3, 0.59, 0.11));
}
static Float least_of(vec3 color) {
    return min(min(color.x(), color.y()), color.z());
}
static Float greatest_of(vec3 color) {
    return max(max(color.x(), color.y()), color.z());
}
// SetLum with ClipColor: the color moved to a luminosity, then drawn towards grey into 0 to 1.
static vec3 with_lum(vec3 color, Float luminosity) {
    const auto set = function("with_luminosity(color, luminosity)", [](vec3 color, Float lum_) {
        const vec3 moved = named("moved", color + (lum_ - lum(color)));
        const Float least = named("least", least_of(moved));
        const Float most = named("most", greatest_of(moved));
        const Float up = named("up", select(least < 0, divide(lum_, lum_ - least), 1));
        const Float down = named("down", select(most > 1, divide(1 - lum_, most - lum_), 1));
        return lum_ + (moved - lum_) * min(up, down);
    });
    return set(color, luminosity);
}
// SetSat: the least component becomes 0, the greatest the saturation.
static vec3 with_sat(vec3 color, Float saturation) {
    const Float least = named("least", least_of(color));
    return divide((color - least) * saturation, greatest_of(color) - least);
}
static Float sat(vec3 color) {
    return greatest_of(color) - least_of(color);
}

static vec3 blended(Mode mode, vec3 base, vec3 top) {
    switch (mode) {
        case Mode::normal:
            return top;
        case Mode::multiply:
            return base * top;
        case Mode::darken:
            return min(base, top);
        case Mode::lighten:
            return max(base, top);
        case Mode::add:
            return base + top;
        case Mode::subtract:
            return base - top;
        case Mode::divide:
            return divide(base, top);
        case Mode::difference:
            return abs(base - top);
        case Mode::exclusion:
            return base + top - 2 * base * top;
        case Mode::linear_light:
            return base + 2 * top - 1;
        case Mode::linear_burn:
            return base + top - 1;
        case Mode::hard_mix:
            return floor(base + top);
        case Mode::hue:
            return with_lum(with_sat(top, sat(base)), lum(base));
        case Mode::saturation:
            return with_lum(with_sat(base, sat(top)), lum(base));
        case Mode::color:
            return with_lum(top, lum(base));
        case Mode::luminosity:
            return with_lum(base, lum(top));
        default:
            return {blended(mode, base.x(), top.x()), blended(mode, base.y(), top.y()),
                    blended(mode, base.z(), top.z())};
    }
}

struct Blend {
    vec3 base, top;
    Float opacity, mask;
    Choice mode, space;
    bool clamp;
};

enum class FloatMode {
    normal,
    add,
    subtract,
    multiply,
    minimum,
    maximum,
    screen,
    overlay,
    smooth_minimum,
    smooth_maximum
};

static Float blended(FloatMode mode, Float base, Float top, Float band) {
    switch (mode) {
        case FloatMode::normal:
            return top;
        case FloatMode::add:
            return base + top;
        case FloatMode::subtract:
            return base - top;
        case FloatMode::multiply:
            return base * top;
        case FloatMode::minimum:
            return min(base, top);
        case FloatMode::maximum:
            return max(base, top);
        case FloatMode::screen:
            return screen(base, top);
        case FloatMode::overlay:
            return hard_light(top, base);
        case FloatMode::smooth_minimum:
            return smooth_minimum(base, top, band).value;
        default:
            return -smooth_minimum(-base, -top, band).value;
    }
}

static constinit Node color_blend_list[] = {
    node("blend", "Blend", "Lays one color over another by a mode: base where the mask is 0.")
        .family("color")
        .in<Color>("base", 0, "The background, linear", slider(0, 1))
        .in<Color>("top", 1, "The foreground, linear", slider(0, 1))
        .in<Float>("opacity", 1, "Strength of the foreground", slider(0, 1), limits(0, 1))
        .in<Float>("mask", 1, "Strength too, to be wired: the two are multiplied", slider(0, 1),
                   limits(0, 1))
        .choice("mode", {"normal",    "multiply",   "screen",      "overlay",      "darken",
                         "lighten",   "add",        "subtract",    "divide",       "difference",
                         "exclusion", "hard_light", "soft_light",  "linear_light", "vivid_light",
                         "pin_light", "hard_mix",   "color_dodge", "color_burn",   "linear_burn",
                         "hue",       "saturation", "color",       "luminosity"},
                "How the colors are combined; the last four take that quality of the foreground")
        .choice("space", {"linear", "display"},
                "Where the formula is applied: linear light, or sRGB display values as Photoshop "
                "and browsers do")
        .flag("clamp", true, "Limits the combined color to 0 to 1, before the mask")
        .out<Color>("color", "The blended color, linear")
        .body([](Blend in) {
            const vec3 base = in_space(in.space, in.base), top = in_space(in.space, in.top);
            const vec3 both = named("both", blended(static_cast<Mode>(int(in.mode)), base, top));
            const vec3 limited = in.clamp ? saturate(both) : both;
            return from_space(in.space, mix(base, limited, in.opacity * in.mask));
        }),

    node("float_blend", "Blend numbers",
         "Lays one height or mask over another by a mode: base where the mask is 0.")
        .family("value")
        .in<Float>("base", 0, "The background", slider(0, 1))
        .in<Float>("top", 1, "The foreground", slider(0, 1))
        .in<Float>("opacity", 1, "Strength of the foreground", slider(0, 1), limits(0, 1))
        .in<Float>("mask", 1, "Strength too, to be wired: the two are multiplied", slider(0, 1),
                   limits(0, 1))
        .choice("mode",
                {"normal", "add", "subtract", "multiply", "minimum", "maximum", "screen", "overlay",
                 "smooth_minimum", "smooth_maximum"},
                "How the numbers are combined")
        .in<Float>("smoothness", 0.1,
                   "The smooth modes round the crease where the difference is less than this",
                   slider(0, 1), limits(0, 1e6))
        .flag("clamp", false, "Limits the combined number to 0 to 1, before the mask")
        .out<Float>("value", "The blended number")
        .body([](Float base, Float top, Float opacity, Float mask, Choice mode, Float smoothness,
                 bool clamp) {
            const Float both =
                named("both", blended(static_cast<FloatMode>(int(mode)), base, top, smoothness));
            return mix(base, clamp ? saturate(both) : both, opacity * mask);
        })};
constinit std::span<Node> color_blend_nodes = color_blend_list;

}  // namespace wrinkle::nodes

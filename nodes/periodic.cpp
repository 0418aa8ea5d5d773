// Single waves of several profiles, and gradients of several shapes, on a uv set. Both are exact
// means over the pixel wherever their position changes linearly over it.
#include "nodes/periodic.h"

#include <span>

#include "nodes/exact_angle.h"
#include "nodes/footprint.h"
#include "nodes/relief.h"
#include "nodes/rotated.h"

namespace wrinkle::nodes {
using namespace sdk;

enum class Waveform { sine, triangle, square, saw, bounce };
enum class Layout { bands, rings };

struct Wave {
    vec2 uv;
    Float scale;
    Waveform waveform;
    Layout layout;
    Float direction;
    vec2 center;
    Float phase, duty, softness, amplitude;
};

// Position in periods.
static Float wave_position(const Wave& in) {
    const vec2 p = named("p", in.uv * in.scale);
    if (in.layout == Layout::rings) return length(p - in.center * in.scale) + in.phase;
    const Float angle = named("angle", radians(in.direction));
    return dot(p, vec2(cos(angle), sin(angle))) + in.phase;
}

// The mean of a sine is that sine times a factor.
static Float sine_mean(Float x, Float width) {
    const Float turn = named("turn", pi() * width);
    const Float strength = select(width > 0, sin(fract(width * 0.5) * two_pi()) / turn, 1);
    return 0.5 - 0.5 * strength * cos(fract(x) * two_pi());
}

// Integral and value of a wave from 0 to 1 of period 1.
static auto saw_wave() {
    return function("saw_wave(x)", [](Float x) {
        const Float count = named("count", floor(x)), f = named("f", x - count);
        return vec2(0.5 * (count + f * f), f);
    });
}
static auto triangle_wave() {
    return function("triangle_wave(x)", [](Float x) {
        const Float count = named("count", floor(x)), f = named("f", x - count);
        const Float down = named("down", max(f - 0.5, 0));
        return vec2(0.5 * count + f * f - 2 * down * down, 1 - triangle(2 * x));
    });
}
static auto square_wave() {
    return function("square_wave(x, duty)", [](Float x, Float duty) {
        const Float count = named("count", floor(x)), f = named("f", x - count);
        const Float start = named("start", 1 - duty);
        return vec2(count * duty + max(f - start, 0), step(start, f));
    });
}
// The arc sine within 2e-8 (Abramowitz and Stegun, 4.4.46): that of a GPU may be off by 1e-4, which
// a difference of integrals over a narrow box multiplies by 512.
static Float exact_arcsine(Float x) {
    const auto arcsine = function("exact_arcsine(x)", [](Float x) {
        constexpr double factors[] = {0.0066700901, -0.0170881256, 0.0308918810, -0.0501743046,
                                      0.0889789874, -0.2145988016, 1.5707963050};
        const Float size = named("size", abs(x));
        Float sum = -0.0012624911;
        for (const double factor : factors)
            sum = sum * size + factor;
        return sign(x) * (0.5 * pi() - sqrt(1 - size) * sum);
    });
    return arcsine(x);
}
// Half circles, scaled to height 1.
static auto bounce_wave() {
    return function("bounce_wave(x)", [](Float x) {
        const Float count = named("count", floor(x)), way = named("way", 2 * (x - count) - 1);
        const Float height = named("height", sqrt(1 - way * way));
        const Float area = 0.25 * (way * height + exact_arcsine(way));
        return vec2(area + 0.25 * pi() * (count + 0.5), height);
    });
}

static Float wave_mean(Waveform waveform, Float x, Float width, Float duty) {
    switch (waveform) {
        case Waveform::sine:
            return sine_mean(x, width);
        case Waveform::triangle:
            return periodic_mean(triangle_wave(), x, width);
        case Waveform::square: {
            const auto wave = square_wave();
            return periodic_mean([&](Float at) { return wave(at, duty); }, x, width);
        }
        case Waveform::saw:
            return periodic_mean(saw_wave(), x, width);
        default:
            return periodic_mean(bounce_wave(), x, width);
    }
}

enum class GradientShape { linear, reflected, radial, diamond, square, angular, spiral };
enum class Easing { linear, ease, quadratic };
enum class Extend { clamp, repeat, mirror };

struct Ramping {
    vec2 uv, center;
    GradientShape shape;
    Float rotation, size;
    int arms;
    Extend extend;
    Easing easing;
    bool reverse;
};

// Position on the gradient, also below 0 and above 1.
static Float gradient_position(const Ramping& in) {
    const vec2 p = named("p", rotated(in.uv - in.center, -radians(in.rotation)) / in.size);
    const vec2 side = named("side", abs(p));
    // The angle takes less rounding than the rotated and scaled point.
    const vec2 from = in.uv - in.center;
    const auto turns = [&] {
        const Float turn = named("turn", exact_angle(from) / two_pi() - in.rotation / 360);
        return (turn - floor(turn + 0.5)) * in.arms;
    };
    switch (in.shape) {
        case GradientShape::linear:
            return 0.5 + 0.5 * p.x();
        case GradientShape::reflected:
            return side.x();
        case GradientShape::radial:
            return length(p);
        case GradientShape::diamond:
            return side.x() + side.y();
        case GradientShape::square:
            return max(side.x(), side.y());
        case GradientShape::angular:
            return turns();
        default:
            return turns() + length(p);
    }
}

static Float eased(Easing easing, Float t) {
    if (easing == Easing::linear) return t;
    return easing == Easing::ease ? t * t * (3 - 2 * t) : t * t;
}
// Its integral from 0.
static Float eased_area(Easing easing, Float t) {
    if (easing == Easing::linear) return 0.5 * t * t;
    return easing == Easing::ease ? t * t * t * (1 - 0.5 * t) : t * t * t / 3;
}

static Float gradient_mean(Extend extend, Easing easing, Float t, Float width) {
    const double whole = easing == Easing::quadratic ? 1.0 / 3 : 0.5;
    if (extend == Extend::clamp) {
        const auto clamped = function("clamped(t)", [easing](Float t) {
            const Float inside = named("inside", saturate(t));
            return vec2(eased_area(easing, inside) + max(t - 1, 0), eased(easing, inside));
        });
        // A box beyond the ends sees a constant: near the ends integrals have more digits.
        const Float reach = named("reach", max(0.5 * width, 1));
        return box_mean(clamped, clamp(t, -reach, 1 + reach), width);
    }
    if (extend == Extend::repeat) {
        const auto repeated = function("repeated(t)", [easing, whole](Float t) {
            const Float count = named("count", floor(t)), f = named("f", t - count);
            return vec2(count * whole + eased_area(easing, f), eased(easing, f));
        });
        return periodic_mean(repeated, t, width);
    }
    const auto mirrored = function("mirrored(t)", [easing, whole](Float t) {
        const Float near = named("near", 1 - triangle(t));  // distance to the nearest even number
        const Float even = named("even", 2 * floor(0.5 * t + 0.5));
        const Float area = eased_area(easing, near);
        return vec2(even * whole + select(t < even, -area, area), eased(easing, near));
    });
    return box_mean(mirrored, t - 2 * floor(0.5 * t), width);
}

static constinit Node periodic_list[] = {
    relief(pattern_on_uv("wave", "Wave",
                         "One wave in bands or rings, like corrugated metal, stairs or grooves. "
                         "Filtered: the mean over the pixel.",
                         "scale", 8, "Periods per uv unit")
               .choice("waveform", {"sine", "triangle", "square", "saw", "bounce"},
                       "sine, triangle and saw start at 0; square is 1 at the end of a period; "
                       "bounce is a row of half circles")
               .choice("layout", {"bands", "rings"}, "Straight bands, or rings around the center")
               .in<Float>("direction", 0, "Where bands follow each other, anticlockwise from u",
                          slider(-180, 180), unit("deg"))
               .in<vec2>("center", 0.5, "The middle of rings", slider(0, 1))
               .in<Float>("phase", 0,
                          "Added to the position, in periods: a noise distorts the wave; with a "
                          "scale of 0, the wave is a function of it",
                          slider(0, 1))
               .in<Float>("duty", 0.5, "The part of its period where a square wave is 1",
                          slider(0, 1), limits(0, 1))
               .in<Float>("softness", 0,
                          "Width of the box that rounds edges, in periods; at least a pixel",
                          slider(0, 0.5), limits(0, 1)),
           0.01, "0 to 1")
        .body([](Wave in) {
            const Float x = named("x", wave_position(in));
            const Float width = named("wide", max(box_width(x), in.softness));
            return relief_of(wave_mean(in.waveform, x, width, in.duty), in.amplitude);
        }),

    node("gradient_shape", "Gradient shape",
         "A number that grows along a line, from a point or around it. Filtered: the mean over "
         "the pixel.")
        .family("pattern")
        .in<vec2>("uv", surface::uv0, "Where to read it, on any uv set")
        .in<vec2>("center", 0.5, "The middle of the gradient", slider(0, 1))
        .choice("shape",
                {"linear", "reflected", "radial", "diamond", "square", "angular", "spiral"},
                "linear: from one side to the other; reflected: to both sides; radial, diamond and "
                "square: outward; angular: around; spiral: both")
        .in<Float>("rotation", 0, "Angle of the gradient, anticlockwise", slider(-180, 180),
                   unit("deg"))
        .in<Float>("size", 0.5,
                   "From the middle to where it is 1, in uv units; a linear one is 0 as far on the "
                   "other side",
                   slider(0.01, 1), limits(1e-6, 1e6))
        .count("arms", 1, 1, 64, "How often an angular or spiral gradient runs from 0 to 1")
        .choice("extend", {"clamp", "repeat", "mirror"},
                "Beyond 0 and 1: constant, from the start again, or back and forth; angular and "
                "spiral ones repeat unless mirrored")
        .choice("easing", {"linear", "ease", "quadratic"},
                "From 0 to 1: straight, eased at both ends, or the square")
        .flag("reverse", false, "Runs from 1 to 0, before the easing")
        .out<Float>("value", "0 to 1")
        .out<Float>("position", "The same without easing and end; 1 at the size")
        .body([](Ramping in) {
            const Float t = named("t", gradient_position(in));
            const bool around =
                in.shape == GradientShape::angular || in.shape == GradientShape::spiral;
            const bool mirrored = in.extend == Extend::mirror;
            const Extend extend = around && !mirrored ? Extend::repeat : in.extend;
            // Up and down within an arm, so that an odd number of arms closes too.
            Float at = around && mirrored ? 2 * t : t;
            if (in.reverse) at = 1 - at;
            return std::tuple{gradient_mean(extend, in.easing, at, box_width(at)), t};
        })};
constinit std::span<Node> periodic_nodes = periodic_list;

}  // namespace wrinkle::nodes

// Numbers from 0 to 1 reshaped: masks, heights without a unit, roughness. Edges have
// at least the width of a pixel.
#include <span>

#include "nodes/footprint.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr auto value_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc).family("value").in<Float>("value", 0, "The number", slider(0, 1));
}

// The curve of K. Perlin 1989: 0.5 becomes `bias`.
static Float biased(Float x, Float bias) {
    return pow(x, -log2(bias));
}

// A step at each whole number of t, smooth over the part before it. The rise has at least the width
// of a pixel, with the same middle; far away the stairs are their straight mean.
static Float staircase(Float t, Float smoothness) {
    const auto stairs = function("staircase(t, part, width)", [](Float t, Float part, Float width) {
        const Float rise = named("rise", saturate(max(part, width)));
        const Float moved = named("moved", t - 0.5 * (rise - part));
        const Float start = named("start", floor(moved));
        const Float stepped = start + smoothstep(1 - rise, 1, moved - start);
        return mix(t + (0.5 * part - 0.5), stepped, fade(width));
    });
    return stairs(t, smoothness, box_width(t));
}

static constinit Node value_list[] = {
    value_family("levels", "Levels",
                 "Brings the range from in_low to in_high to out_low to out_high, with a gamma "
                 "between; a step where the range is empty.")
        .in<Float>("in_low", 0, "Start of the range; below it the result is out_low", slider(0, 1))
        .in<Float>("in_high", 1, "End of the range; above it the result is out_high", slider(0, 1))
        .in<Float>("gamma", 1, "Above 1 lifts the middle, below 1 lowers it", slider(0.1, 4),
                   limits(0.01, 100))
        .in<Float>("out_low", 0, "Result at the start", slider(0, 1))
        .in<Float>("out_high", 1, "Result at the end", slider(0, 1))
        .out<Float>("value", "From out_low to out_high")
        .body([](Float x, Float in_low, Float in_high, Float gamma, Float out_low, Float out_high) {
            const Float range = named("range", in_high - in_low);
            const Float share = saturate((x - in_low) / select(range != 0, range, 1));
            const Float level = named("level", select(range != 0, share, step(in_low, x)));
            return mix(out_low, out_high, pow(level, 1 / gamma));
        }),

    value_family("contrast", "Contrast", "Makes differences from a pivot greater or smaller.")
        .in<Float>("amount", 1, "1 leaves it unchanged, 0 gives the pivot, negative inverts",
                   slider(0, 4))
        .in<Float>("pivot", 0.5, "The number that does not change", slider(0, 1))
        .out<Float>("value", "The number with the other contrast")
        .body([](Float x, Float amount, Float pivot) { return (x - pivot) * amount + pivot; }),

    value_family("bias", "Bias", "Bends the range from 0 to 1 up or down.")
        .in<Float>("bias", 0.5, "Result for 0.5; 0.5 leaves it unchanged", slider(0.05, 0.95),
                   limits(0.001, 0.999))
        .out<Float>("value", "0 to 1; 0 for negative numbers")
        .body([](Float x, Float bias) { return biased(x, bias); }),

    value_family("gain", "Gain",
                 "Bends the range from 0 to 1 towards its ends or towards its middle.")
        .in<Float>("gain", 0.5, "Above 0.5 towards the ends; 0.5 leaves it unchanged",
                   slider(0.05, 0.95), limits(0.001, 0.999))
        .out<Float>("value", "0 to 1")
        .body([](Float x, Float gain) {
            const Bool lower = x < 0.5;
            const Float half = named("half", select(lower, 2 * x, 2 - 2 * x));
            const Float bent = named("bent", 0.5 * biased(half, 1 - gain));
            return select(lower, bent, 1 - bent);
        }),

    value_family("quantize", "Quantize",
                 "Rounds down to equal steps, smooth over the last part of each.")
        .in<Float>("steps", 4, "Steps from 0 to 1", slider(1, 16), limits(1, 1e6))
        .in<Float>("smoothness", 0.1, "Share of a step that rises to the next", slider(0, 1),
                   limits(0, 1))
        .out<Float>("value", "Multiples of 1 / steps, and slopes between them")
        .body([](Float x, Float steps, Float smoothness) {
            return staircase(named("t", x * steps), smoothness) / steps;
        }),

    value_family("threshold", "Threshold", "0 below an edge, 1 above, smooth around it.")
        .in<Float>("edge", 0.5, "Where the result is 0.5", slider(0, 1))
        .in<Float>("softness", 0, "Width of the slope; at least a pixel", slider(0, 1),
                   limits(0, 1e6))
        .out<Float>("value", "0 to 1")
        .body([](Float x, Float edge, Float softness) {
            const Float half = named("half", 0.5 * max(softness, box_width(x)));
            return smoothstep(edge - half, edge + half, x);
        }),

    value_family("ping_pong", "Ping-pong", "Runs to and fro between 0 and a scale.")
        .in<Float>("scale", 1, "Where it turns; 0 gives 0", slider(0, 1))
        .out<Float>("value", "0 to scale")
        .body([](Float x, Float scale) {
            return abs(fract(divide(x - scale, 2 * scale)) * 2 * scale - scale);
        }),

    value_family("wrap", "Wrap", "Repeats a range; its start where it is empty.")
        .in<Float>("low", 0, "Start of the range", slider(0, 1))
        .in<Float>("high", 1, "End of the range", slider(0, 1))
        .out<Float>("value", "low to high")
        .body([](Float x, Float low, Float high) { return low + mod(x - low, high - low); }),

    value_family("invert", "Invert", "1 less the number.")
        .out<Float>("value", "1 - value")
        .body([](Float x) { return 1 - x; }),

    value_family("histogram_scan", "Histogram scan",
                 "Lets white spread over a grayscale: a threshold that moves with the position.")
        .in<Float>("position", 0.5, "0 is all black, 1 all white", slider(0, 1), limits(0, 1))
        .in<Float>("contrast", 0.5, "0 is soft, 1 an edge of one pixel", slider(0, 1), limits(0, 1))
        .out<Float>("value", "0 to 1")
        .body([](Float x, Float position, Float contrast) {
            const Float half = named("half", max(max(1 - contrast, box_width(x)) * 0.5, 1e-5));
            const Float centre = named("centre", mix(1 + half, -half, position));
            return saturate((x - centre) / (2 * half) + 0.5);
        }),

    value_family("histogram_range", "Histogram range",
                 "Shrinks the range from 0 to 1 and moves it.")
        .in<Float>("range", 1, "Width of the range", slider(0, 1), limits(0, 1))
        .in<Float>("position", 0.5, "0 is at the lower end, 1 at the upper end", slider(0, 1),
                   limits(0, 1))
        .out<Float>("value", "The number in that range")
        .body([](Float x, Float range, Float position) {
            return x * range + (1 - range) * position;
        })};
constinit std::span<Node> value_nodes = value_list;

}  // namespace wrinkle::nodes

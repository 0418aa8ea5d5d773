#include "nodes/spline.h"

namespace wrinkle::nodes {
using namespace sdk;

// The part of a box around x that is above an edge.
static Float share_above(Float edge, Float x, Float width) {
    return saturate((x - edge) / width + 0.5);
}

// A box around x against a segment: the shares of the box inside and after the segment, and the
// ends of the inside part, from 0 to 1 over the segment. No difference of near values: exact for
// narrow boxes too.
struct Overlap {
    Float after, inside, low, high;

    Overlap(Float x, Float width, Float start, Float gap)
        : after(named("after", share_above(start + gap, x, width))),
          inside(named("inside", share_above(start, x, width) - after)),
          low(named("low", saturate((x - 0.5 * width - start) / gap))),
          high(named("high", saturate((x + 0.5 * width - start) / gap))) {}

    // Returns the mean of a polynomial over the inside part. Simpson's rule is exact for cubics.
    template <class Cubic>
    auto mean(Cubic cubic) const {
        const Float middle = named("middle", 0.5 * (low + high));
        return (cubic(low) + 4 * cubic(middle) + cubic(high)) / 6;
    }
};

// Segments from 0 to 1.
static Float linear_segment(Float x, Float width, Float start, Float gap) {
    const auto segment = function("linear_segment(x, width, start, gap)",
                                  [](Float x, Float width, Float start, Float gap) {
                                      const Overlap box(x, width, start, gap);
                                      return box.after + box.inside * (0.5 * (box.low + box.high));
                                  });
    return segment(x, width, start, gap);
}
static Float ease_segment(Float x, Float width, Float start, Float gap) {
    const auto segment = function(
        "ease_segment(x, width, start, gap)", [](Float x, Float width, Float start, Float gap) {
            const Overlap box(x, width, start, gap);
            const Float mean = box.mean([](Float t) { return t * t * (3 - 2 * t); });
            return box.after + box.inside * mean;
        });
    return segment(x, width, start, gap);
}

// A segment from 0 to `rise` with slopes at its ends, which are changes over the gap.
template <class V>
static V smooth_segment(Float x, Float width, Float start, Float gap, V rise, V first, V last) {
    const auto segment =
        function("smooth_segment(x, width, start, gap, rise, first, last)",
                 [](Float x, Float width, Float start, Float gap, V rise, V first, V last) {
                     const Overlap box(x, width, start, gap);
                     const auto hermite = function("hermite(t)", [](Float t) {
                         const Float back = named("back", 1 - t);
                         return vec3(t * t * (3 - 2 * t), t * back * back, -(t * t * back));
                     });
                     const vec3 weights = named("weights", box.mean(hermite));
                     const V mean = weights.x() * rise + weights.y() * first + weights.z() * last;
                     return box.after * rise + box.inside * mean;
                 });
    return segment(x, width, start, gap, rise, first, last);
}

// The slope at an inner point, of the secants and gaps on either side: a weighted harmonic mean, 0
// where the secants differ in sign.
template <class V>
static V inner_slope(V before, V after, Float gap_before, Float gap_after) {
    const Float w1 = 2 * gap_after + gap_before, w2 = gap_after + 2 * gap_before;
    const V product = named("product", max(before * after, 0));
    const V sum = named("sum", max(w1 * abs(after) + w2 * abs(before), 1e-30));
    return sign(before) * (w1 + w2) * product / sum;
}
// The slope at an end: that of a parabola through three points, of the sign of the first secant
// and at most three times as steep.
template <class V>
static V end_slope(V secant, V next, Float gap, Float next_gap) {
    const V parabola = ((2 * gap + next_gap) * secant - gap * next) / (gap + next_gap);
    const V side = named("side", sign(secant));
    return side * min(max(side * parabola, 0), 3 * abs(secant));
}

// Secants and slopes at all points.
template <class V>
static std::vector<V> slopes(const std::vector<V>& secants, const std::vector<Float>& gaps) {
    const size_t last = secants.size() - 1;
    if (last == 0) return {secants[0], secants[0]};
    std::vector<V> slopes{end_slope(secants[0], secants[1], gaps[0], gaps[1])};
    for (size_t k = 0; k < last; ++k)
        slopes.push_back(inner_slope(secants[k], secants[k + 1], gaps[k], gaps[k + 1]));
    slopes.push_back(end_slope(secants[last], secants[last - 1], gaps[last], gaps[last - 1]));
    return slopes;
}

template <class V>
V spline(const Knots<V>& knots, Interpolation interpolation, Float x, Float width) {
    const size_t segments = knots.value.size() - 1;
    width = max(width, 1e-5);
    std::vector<Float> starts{knots.position[0]}, gaps;
    std::vector<V> rises, secants;
    for (size_t k = 0; k < segments; ++k) {
        const Float next = max(starts[k], knots.position[k + 1]);
        starts.push_back(next);
        gaps.push_back(max(next - starts[k], 1e-6));
        rises.push_back(knots.value[k + 1] - knots.value[k]);
        secants.push_back(rises[k] / gaps[k]);
    }
    std::vector<V> at = slopes(secants, gaps);
    V sum = knots.value[0];
    for (size_t k = 0; k < segments; ++k) {
        const Float start = starts[k], gap = gaps[k];
        if (interpolation == Interpolation::constant)
            sum += rises[k] * share_above(starts[k + 1], x, width);
        else if (interpolation == Interpolation::linear)
            sum += rises[k] * linear_segment(x, width, start, gap);
        else if (interpolation == Interpolation::ease)
            sum += rises[k] * ease_segment(x, width, start, gap);
        else
            sum += smooth_segment(x, width, start, gap, rises[k], gap * at[k], gap * at[k + 1]);
    }
    return sum;
}
template Float spline(const Knots<Float>&, Interpolation, Float, Float);
template vec3 spline(const Knots<vec3>&, Interpolation, Float, Float);

}  // namespace wrinkle::nodes

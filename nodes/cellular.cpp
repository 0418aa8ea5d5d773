// Relief from random points or strokes, a fixed number per cell: each position evaluates its cell
// and the cells around it.
#include <span>

#include "nodes/footprint.h"
#include "nodes/random.h"
#include "nodes/relief.h"

namespace wrinkle::nodes {
using namespace sdk;

// Returns an offset among the offsets -1, 0, 1 by axis, which repeat; `stride` is 1, 3, 9, and
// `middle` its index and a half, which guards against inexact division.
template <class V>
static V offset(Float middle, V stride) {
    return floor(mod(middle / stride, 3)) - 1;
}
static Float middle_of(Int index) {
    return Float(index) + 0.5;
}

// Returns the feature point of a cell, relative to the cell's centre.
static vec3 feature(vec3 cell, Float jitter) {
    const auto point = function("feature_point(cell, jitter)", [](vec3 cell, Float jitter) {
        return (random3(named("bits", hash(cell))) - 0.5) * jitter;
    });
    return point(cell, jitter);
}

enum class Distance { first, second, difference };

// Returns a distance in cells to the nearest or the second nearest feature point (S. Worley 1996),
// or their difference; the mean where a pixel covers cells. Each cell has one point, per axis at
// most jitter / 2 cells from its centre. Points two cells away are ignored; at full jitter this
// changes the second distance at a few of 10,000 positions. The search returns cells, which do not
// depend on the position, so only the distances to their points are differentiated.
static Float worley(vec3 point, Float scale, Float jitter, Distance which, int seed) {
    const auto search = [](vec3 cell, vec3 from, Float jitter) {
        using State = std::tuple<Int, Float, Float, vec3, vec3>;
        const auto each = [&](Int k, Float first, Float second, vec3 nearest, vec3 next) {
            const vec3 step = named("offset", offset(middle_of(k), vec3(1, 3, 9)));
            const vec3 way = named("way", step + feature(cell + step, jitter) - from);
            const Float square = named("square", dot(way, way));
            const Bool closer = square < first, close = square < second;
            return std::tuple{Bool(true),
                              k + 1,
                              min(first, square),
                              min(second, max(first, square)),
                              select(closer, step, nearest),
                              select(closer, nearest, select(close, step, next))};
        };
        const auto [k, first, second, nearest, next] = loop(
            "cells(k, first, second, nearest, next)", 27, State{0, 9, 9, vec3(0), vec3(0)}, each);
        return std::tuple{nearest, next};
    };
    const auto distance =
        function("worley(point, width, scale, jitter)",
                 [&](vec3 point, Float width, Float scale, Float jitter) {
                     const vec3 p = named("p", point * scale), corner = named("cell", floor(p));
                     const vec3 from = named("from", p - corner - 0.5);
                     const vec3 cell = seeded_cell(corner, seed);
                     const auto [nearest, next] = search(cell, detach(from), detach(jitter));
                     const auto distance_to = [&](const char* name, vec3 step) {
                         return length(named(name, step + feature(cell + step, jitter) - from));
                     };
                     const Float first = distance_to("to_nearest", nearest);
                     const Float second = distance_to("to_next", next);
                     const Float found[] = {first, second, second - first};
                     const Float mean[] = {0.48 + 0.04 * jitter, 0.703 + 0.015 * jitter,
                                           0.223 - 0.025 * jitter};  // measured
                     const auto k = static_cast<size_t>(which);
                     return mix(named("mean", mean[k]), found[k], fade(width, scale));
                 });
    return distance(point, footprint(point), scale, jitter);
}

// Worley noise that reports the slopes which it removes. A distance has slope 1; the variance of
// the difference is measured.
static Float filtered_worley(vec3 point, Float scale, Float jitter, Distance which, int seed) {
    const Float difference = 1.04 - 0.285 * jitter;
    const Float variance = which == Distance::difference ? difference : Float(1.0 / 3);
    const Float lost = variance * lost_share(fade(footprint(point), scale));
    return worley(point, scale, jitter, which, seed) + lost_slope(point * scale, lost);
}

static constexpr int most_layers = 4;

struct Scratches {
    vec2 uv;
    Float scale, density, length, width, direction, spread;
    int layers, seed;
    Float amplitude;
};

// Returns the depth of a stroke at a position. A stroke may begin in each of 9 cells of a layer;
// the index counts those of all layers. `size` is (length, width), `angles` (direction, spread).
static Float stroke_at(vec2 p, Int index, Float density, vec2 size, vec2 angles, int seed) {
    const Float middle = named("middle", middle_of(index));
    const Float layer = named("layer", floor(middle / 9));
    const vec2 moved = named("moved", p + vec2(0.37, 0.61) * layer);
    const vec2 cell = named("cell", floor(moved) + offset(middle, vec2(1, 3)));
    const Uint bits = named("bits", hash(seeded_cell(vec3(cell, layer), seed)));
    const Uint more =
        named("more", hash(bits ^ named("golden_bits // 2^32 / golden ratio", Uint(0x9e3779b9u))));
    const vec3 random = named("random", random3(bits));
    const Float angle = named("angle", angles.x() + (random.z() - 0.5) * angles.y());
    const vec2 along = named("along", vec2(cos(angle), sin(angle)));
    const vec2 way = named("way", moved - cell - random.xy());
    const Float half = named("half_length", size.x() * (0.25 + 0.25 * unit_float(more)));
    const vec2 across = named("across", vec2(along.y(), -along.x()));
    const Float side = named("side", dot(way, across) / size.y());
    const Float end = named("end", dot(way, along) / half);
    const Float profile = named("profile", smoothstep(0, 1, named("inside", 1 - abs(side))));
    const Float depth = profile * named("taper", max(named("rest", 1 - end * end), 0));
    return select(named("drawn", unit_float(hash(more)) < density), depth, 0.0);
}

// Returns the depth of the deepest stroke. As with points, the search returns the stroke's index,
// and only that stroke is differentiated.
static Float strokes(const Scratches& in) {
    const auto stroke =
        function("scratch(p, index, density, size, angles)",
                 [seed = in.seed](vec2 p, Int index, Float density, vec2 size, vec2 angles) {
                     return stroke_at(p, index, density, size, angles, seed);
                 });
    const auto deepest = function(
        "scratches(uv, width, scale, layers, density, size, angles)",
        [&](vec2 uv, Float width, Float scale, Int layers, Float density, vec2 size, vec2 angles) {
            const vec2 p = named("p", uv * scale), here = detach(p);
            const Int count = layers * 9;
            const auto each = [&](Int k, Float deepest, Int found) {
                const Float depth = named("stroke", stroke(here, k, density, size, angles));
                return std::tuple{k < count, k + 1, max(deepest, depth),
                                  select(deepest < depth, k, found)};
            };
            const auto [k, least, found] = loop("strokes(k, deepest, found)", 9 * most_layers,
                                                std::tuple<Int, Float, Int>{0, 0, 0}, each);
            // The volume of a stroke is its width times 2/3 of its length; the mean length is 3/4
            // of the longest.
            const Float mean =
                named("mean", saturate(size.x() * size.y() * density * (0.5 * Float(layers))));
            const Float depth = named("stroke", stroke(p, found, density, size, angles));
            return mix(mean, depth, fade(width / (4 * size.y()), scale));
        });
    return deepest(in.uv, footprint(in.uv), in.scale, in.layers, in.density,
                   vec2(in.length, in.width), vec2(radians(in.direction), radians(in.spread)));
}

static constinit Node cellular_list[] = {
    relief(noise_in_space("worley_noise", "Worley noise",
                          "Cells around random points in space: pebbles by the distance to the "
                          "nearest, cracks by f2_minus_f1.",
                          6)
               .in<Float>("jitter", 1, "How irregular: 0 is a grid of points", slider(0, 1),
                          limits(0, 1))
               .choice("distance", {"f1", "f2", "f2_minus_f1"},
                       "To the nearest point, to the second nearest, or their difference, which is "
                       "0 between cells")
               .count("seed", 0, 0, 65535, seed_doc),
           0.03, "The distance in cells, 0 to about 1")
        .body([](vec3 point, Float scale, Float jitter, Choice which, int seed, Float amplitude) {
            const Float value = filtered_worley(point, scale, jitter, which, seed);
            return relief_of(value, amplitude);
        }),

    relief(
        pattern_on_uv("scratches", "Scratches",
                      "Random grooves on a uv set: at most one stroke in a cell and layer, turned "
                      "any way or all one way.",
                      "scale", 4, "Cells per uv unit")
            .in<Float>("density", 0.7, "Share of the cells that have a stroke", slider(0, 1),
                       limits(0, 1))
            .in<Float>("length", 1.4, "Length of the longest strokes, in cells", slider(0.1, 1.5),
                       limits(0.001, 1.5))
            .in<Float>("width", 0.06, "From the middle of a stroke to its rim, in cells",
                       slider(0.04, 0.25), limits(0.001, 0.25))
            .in<Float>("direction", 0, "Angle of the strokes, anticlockwise from u",
                       slider(-180, 180), unit("deg"))
            .in<Float>("spread", 360, "How far they turn away from it in all", slider(0, 360),
                       unit("deg"))
            .count("layers", 2, 1, most_layers, "How many strokes may lie in a cell")
            .count("seed", 0, 0, 65535, seed_doc),
        0.004, "How deep, 0 to -1")
        .body([](Scratches in) { return relief_of(-named("value", strokes(in)), in.amplitude); })};
constinit std::span<Node> cellular_nodes = cellular_list;

}  // namespace wrinkle::nodes

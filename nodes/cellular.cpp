// Relief from random points or strokes, a fixed number per cell: each position evaluates its cell
// and the cells around it.
#include <span>

#include "nodes/footprint.h"
#include "nodes/relief.h"

namespace wrinkle::nodes {
using namespace sdk;

// Returns three numbers in [0, 1) from `bits` and two further hashes.
static vec3 random3(Uint bits) {
    const Uint second = hash(bits);
    return {unit_float(bits), unit_float(second), unit_float(hash(second))};
}

// Returns one component (by `stride`) of offset `index` among the 27 or 9 offsets -1, 0, 1 by axis.
// The half guards against inexact division.
static Float offset(Float index, double stride) {
    const Float k = floor((index + 0.5) * (1 / stride));
    return k - 3 * floor((k + 0.5) * (1.0 / 3)) - 1;
}

// Returns the distances in cells to the nearest and the second nearest feature point (S. Worley
// 1996). Each cell has one point, at most jitter / 2 cells from its centre per axis. Points two
// cells away are ignored; at full jitter this changes the second distance at a few of 10,000
// positions. The search returns cells, which do not depend on the position, so only the two
// resulting distances are differentiated.
static std::pair<Float, Float> worley(vec3 p, Float jitter) {
    const auto feature = function("feature_point", [](vec3 cell, Float jitter) {
        const Uint bits = hash(Int(cell.x()), Int(cell.y()), Int(cell.z()));
        return (random3(bits) - 0.5) * jitter;
    });
    const auto search = function("nearest_cells", [feature](vec3 cell, vec3 from, Float jitter) {
        using State = std::tuple<Float, Float, Float, vec3, vec3>;
        const auto each = [&](Float k, Float first, Float second, vec3 nearest, vec3 next) {
            const vec3 step(offset(k, 1), offset(k, 3), offset(k, 9));
            const vec3 way = step + feature(cell + step, jitter) - from;
            const Float square = dot(way, way);
            const Bool closer = square < first, close = square < second;
            return std::tuple{Bool(true),
                              k + 1,
                              min(first, square),
                              min(second, max(first, square)),
                              select(closer, step, nearest),
                              select(closer, nearest, select(close, step, next))};
        };
        const auto [k, first, second, nearest, next] =
            loop(27, State{0, 9, 9, vec3(0), vec3(0)}, each);
        return std::tuple{nearest, next};
    });
    const vec3 cell = floor(p), from = p - cell - 0.5;
    const auto [nearest, next] = search(cell, detach(from), detach(jitter));
    return {length(nearest + feature(cell + nearest, jitter) - from),
            length(next + feature(cell + next, jitter) - from)};
}

struct Scratches {
    vec2 uv;
    Float scale, density, length, width, direction, spread;
    int layers;
    Float amplitude;
};

// Returns the depth of a layer's strokes at p. As with points, the search returns the cell with the
// deepest stroke, and only that stroke is differentiated.
static Float strokes(const Scratches& in, vec2 p, Int layer) {
    const Float direction = radians(in.direction), spread = radians(in.spread);
    // `from` is the offset from the cell's lower left corner.
    const auto stroke = function("scratch", [=](vec2 cell, vec2 from, Int layer) {
        const Uint bits = hash(Int(cell.x()), Int(cell.y()), layer);
        const vec3 random = random3(bits);
        const Uint more = hash(bits ^ 0x9e3779b9u);
        const Float angle = direction + (random.z() - 0.5) * spread;
        const vec2 along(cos(angle), sin(angle));
        const vec2 way = from - random.xy();
        const Float half = in.length * (0.25 + 0.25 * unit_float(more));
        const Float t = clamp(dot(way, along), -half, half);
        const Float near = saturate(1 - length(way - along * t) / in.width);
        const Float end = divide(t, half);
        const Float depth = near * near * (3 - 2 * near) * (1 - end * end);
        return select(unit_float(hash(more)) < in.density, depth, 0.0);
    });
    const auto search = function("deepest_scratch", [stroke](vec2 cell, vec2 from, Int layer) {
        const auto each = [&](Float k, Float deepest, vec2 found) {
            const vec2 step(offset(k, 1), offset(k, 3));
            const Float depth = stroke(cell + step, from - step, layer);
            return std::tuple{Bool(true), k + 1, max(deepest, depth),
                              select(deepest < depth, step, found)};
        };
        const auto [k, deepest, found] =
            loop(9, std::tuple<Float, Float, vec2>{0, 0, vec2(0)}, each);
        return found;
    });
    const vec2 cell = floor(p), from = p - cell;
    const vec2 found = search(cell, detach(from), layer);
    return stroke(cell + found, from - found, layer);
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
                       "0 between cells"),
           0.03, "The distance in cells, 0 to about 1")
        .body([](vec3 point, Float scale, Float jitter, Choice which, Float amplitude) {
            const vec3 p = point * scale;
            const auto [first, second] = worley(p, jitter);
            const Float found[] = {first, second, second - first};
            const Float mean[] = {0.48 + 0.04 * jitter, 0.703 + 0.015 * jitter,
                                  0.223 - 0.025 * jitter};  // measured
            const Float value = mix(mean[which], found[which], fade(footprint(p)));
            return relief_of(value, amplitude);
        }),

    relief(
        pattern_on_uv("scratches", "Scratches",
                      "Random grooves on a uv set: at most one stroke in a cell and layer, turned "
                      "any way or all one way.",
                      "scale", 4, "Cells per uv unit")
            .in<Float>("density", 0.7, "Share of the cells that have a stroke", slider(0, 1),
                       limits(0, 1))
            .in<Float>("length", 1.4, "Of the longest strokes, in cells", slider(0, 1.5),
                       limits(0, 1.5))
            .in<Float>("width", 0.06, "From the middle of a stroke to its rim, in cells",
                       slider(0.04, 0.25), limits(0.001, 0.25))
            .in<Float>("direction", 0, "Of the strokes, anticlockwise from u", slider(-180, 180),
                       unit("deg"))
            .in<Float>("spread", 360, "How far they turn away from it in all", slider(0, 360),
                       unit("deg"))
            .count("layers", 2, 1, 4, "How many strokes may lie in a cell"),
        0.004, "How deep, 0 to -1")
        .body([](Scratches in) {
            Float depth = 0;
            for (int layer = 0; layer < in.layers; ++layer) {
                const vec2 p = in.uv * in.scale + vec2(0.37 * layer, 0.61 * layer);
                depth = max(depth, strokes(in, p, layer));
            }
            // The volume of a stroke is its width times 2/3 of its length; the mean length is 3/4
            // of the longest.
            const Float mean = saturate(in.length * in.width * in.density * (0.5 * in.layers));
            const Float grooves = footprint(in.uv * in.scale) / (4 * in.width);
            return relief_of(-mix(mean, depth, fade(grooves)), in.amplitude);
        })};
constinit std::span<Node> cellular_nodes = cellular_list;

}  // namespace wrinkle::nodes

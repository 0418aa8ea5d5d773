// Voronoi cells on a uv set, with the exact distance to their edges.
#include <span>

#include "nodes/cells.h"
#include "nodes/tile_edges.h"

namespace wrinkle::nodes {
using namespace sdk;

struct Voronoi {
    vec2 uv;
    Float scale, jitter, mortar, bevel;
    int seed;
    Float amplitude;
};

// The feature point of a square, relative to the square's middle.
static vec2 feature2(vec2 square, Float jitter, Int seed) {
    const auto point =
        function("feature2(cell, jitter, seed)", [](vec2 cell, Float jitter, Int seed) {
            const vec3 random = random3(hash(vec3(cell, Float(seed))));
            return (random.xy() - 0.5) * jitter;
        });
    return point(square, jitter, seed);
}

// Returns the squares of the nearest and of the second nearest point (3 x 3 squares), and of the
// neighbour behind the nearest edge (5 x 5: fewer miss edges), all relative to `square`.
static std::tuple<vec2, vec2, vec2> search(vec2 square, vec2 from, Float jitter, Int seed) {
    using Nearest = std::tuple<Int, Float, Float, vec2, vec2>;
    const auto to = [&](vec2 step) { return step + feature2(square + step, jitter, seed) - from; };
    const auto nearer = [&](Int k, Float first, Float second, vec2 nearest, vec2 next) {
        const vec2 step = named("offset", offset2(k, 3)), way = named("way", to(step));
        const Float length = named("square_length", dot(way, way));
        const Bool closer = length < first, close = length < second;
        return std::tuple{Bool(true),
                          k + 1,
                          min(first, length),
                          min(second, max(first, length)),
                          select(closer, step, nearest),
                          select(closer, nearest, select(close, step, next))};
    };
    const auto [k, first, second, nearest, next] = loop(
        "points(k, first, second, nearest, next)", 9, Nearest{0, 9, 9, vec2(0), vec2(0)}, nearer);
    const vec2 cell = nearest, own = named("own", to(nearest));
    using Edge = std::tuple<Int, Float, vec2>;
    const auto edge = [&](Int k, Float least, vec2 found) {
        const vec2 step = named("offset", offset2(k, 5)), way = named("way", to(step));
        const vec2 across = named("across", way - own);
        const Float distance = named("distance", dot(0.5 * (own + way), normalize(across)));
        const Bool other = step.x() != cell.x() || step.y() != cell.y();
        const Bool closer = other && distance < least;
        return std::tuple{Bool(true), k + 1, select(closer, distance, least),
                          select(closer, step, found)};
    };
    const auto [j, least, neighbour] = loop("edges(k, least, found)", 25, Edge{0, 9, next}, edge);
    return {nearest, next, neighbour};
}

// Vectors from a position. They are read at the detached position, so that the search runs once,
// and change as the position does.
struct Found {
    vec2 own, second;  // to the nearest and the second nearest point
    vec2 across;       // from the nearest point to the neighbour
    vec2 cell;
};
static Found found_at(vec2 p, Float jitter, int seed) {
    const auto cells = function("voronoi(p, jitter, seed)", [](vec2 p, Float jitter, Int seed) {
        const vec2 square = named("square", floor(p)), from = named("from", p - square - 0.5);
        const auto [nearest, next, neighbour] = search(square, from, jitter, seed);
        const auto to = [&](const char* name, vec2 step) {
            return named(name, step + feature2(square + step, jitter, seed) - from);
        };
        const vec2 own = to("own", nearest), second = to("second", next);
        return std::tuple{own, second, to("other", neighbour) - own,
                          named("cell", square + nearest)};
    });
    const auto [own, second, across, cell] = cells(detach(p), detach(jitter), Int(seed));
    const vec2 moved = p - detach(p);
    return {own - moved, second - moved, across, cell};
}

static constinit Node voronoi_list[] = {
    cell_outputs(
        relief(with_edges(pattern_on_uv("voronoi", "Voronoi cells",
                                        "Cells around random points, like cracked mud or scales, "
                                        "with exact edges and numbers of each cell.",
                                        "scale", 6, "Cells per uv unit")
                              .in<Float>("jitter", 1, "How irregular: 0 is a grid of squares",
                                         slider(0, 1), limits(0, 1)),
                          0.05, 0.15, "Width of the groove's bottom, in cells")
                   .count("seed", 0, 0, 65535, "Another seed gives other cells"),
               0.01, "1 on a cell, 0 in the grooves")
            .out<Float>("f1", "Distance to the nearest point, in cells")
            .out<Float>("f2", "Distance to the second nearest point, in cells"))
        .body([](Voronoi in) {
            const vec2 p = named("p", in.uv * in.scale);
            const Found found = found_at(p, in.jitter, in.seed);
            const Float edge = dot(found.own + 0.5 * found.across, normalize(found.across));
            const CellAt at{found.cell, -found.own, vec2(1), named("edge", edge), footprint(p)};
            const Edges edges{in.mortar, in.bevel, at.width};
            const Float tops = saturate(1 - 0.97 * edges.groove());
            const Float value = edges.tile(at.edge, tops * tops) +
                                lost_slope(p, edges.lost(edges.grooves(vec2(1))));
            return std::tuple_cat(relief_of(value, in.amplitude),
                                  std::tuple{length(found.own), length(found.second)},
                                  cell_values(at, in.uv, in.scale, in.seed));
        })};
constinit std::span<Node> voronoi_nodes = voronoi_list;

}  // namespace wrinkle::nodes

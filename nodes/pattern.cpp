// Regular relief on a uv set: tiles with grooves between them, and shapes in a grid.
#include <span>

#include "nodes/cells.h"
#include "nodes/constants.h"
#include "nodes/periodic.h"
#include "nodes/relief.h"
#include "nodes/tile_edges.h"

namespace wrinkle::nodes {
using namespace sdk;

static constinit Node pattern_list[] = {
    cell_outputs(
        relief(pattern_on_uv("checker", "Checker",
                             "Squares in two heights, like a chessboard; box-filtered exactly.",
                             "scale", 4, "Squares per uv unit")
                   .in<Float>("bevel", 0.1, "Width of the slope between two squares, in squares",
                              slider(0.05, 1), limits(0.02, 1))
                   .count("seed", 0, 0, 65535, seed_doc),
               0.01, "1 on the one kind of squares, 0 on the other"))
        .body([](vec2 uv, Float scale, Float bevel, int seed, Float amplitude) {
            const vec2 p = named("p", uv * scale);
            const vec2 width = named("width", max(spread(p), bevel));
            const vec2 wave =
                named("side", (triangle(p - width * 0.5) - triangle(p + width * 0.5)) / width);
            const vec2 cell = named("cell", floor(p)), way = named("way", p - cell - 0.5);
            const Float edge = 0.5 - max(abs(way.x()), abs(way.y()));
            return std::tuple_cat(
                relief_of(0.5 + 0.5 * wave.x() * wave.y(), amplitude),
                cell_values({cell, way, vec2(1), edge, footprint(p)}, uv, scale, seed));
        }),

    relief(
        with_edges(pattern_on_uv("brick", "Bricks",
                                 "A wall of bricks, with mortar between them and bevelled edges.",
                                 "scale", 6, "Rows of bricks per uv unit")
                       .in<Float>("aspect", 2.5, "Length of a brick over its height",
                                  slider(0.5, 6), limits(0.1, 100), unit("x"))
                       .in<Float>("offset", 0.5,
                                  "How far each row is moved against the one below, in bricks",
                                  slider(0, 1)),
                   0.06, 0.15, "Width of the mortar's bottom, in heights of a brick"),
        0.008, "1 on a brick, 0 in the mortar")
        .body([](vec2 uv, Float scale, Float aspect, Float offset, Float mortar, Float bevel,
                 Float amplitude) {
            const vec2 p = named("p", uv * scale);
            const Float row = named("row", floor(p.y()));
            const Float x = named("x", fract(p.x() / aspect - row * offset) - 0.5);
            const Float y = named("y", p.y() - row - 0.5);
            const Float along = named("along", (0.5 - abs(x)) * aspect);
            const Float across = named("across", 0.5 - abs(y));
            const Edges edges{mortar, bevel, footprint(p)};
            const Float inside = named("inside", min(along, across));
            const Float lost = lost_slope(p, edges.lost(edges.grooves(vec2(aspect, 1))));
            return relief_of(edges.tile(inside, edges.mean(vec2(aspect, 1))) + lost, amplitude);
        }),

    cell_outputs(
        relief(with_edges(
                   pattern_on_uv("hexagons", "Hexagons",
                                 "Hexagonal tiles with grooves between them and bevelled edges, "
                                 "and numbers of each tile.",
                                 "scale", 5, "Tiles per uv unit, along u"),
                   0.04, 0.15, "Width of the groove's bottom, in tiles")
                   .count("seed", 0, 0, 65535, seed_doc),
               0.008, "1 on a tile, 0 in the grooves"))
        .body([](vec2 uv, Float scale, Float mortar, Float bevel, int seed, Float amplitude) {
            // Centres are on two rectangular grids, 1 by sqrt(3); the nearer centre is the tile's.
            const vec2 grid(
                1, named("sqrt_3 // height of the grid's cells", Float(1.7320508075688772)));
            const vec2 p = named("p", uv * scale);
            const vec2 square = named("square", floor(p / grid));
            const vec2 corner = named("corner", floor(p / grid + 0.5));
            const vec2 even = named("even", p - grid * corner);
            const vec2 odd = named("odd", p - grid * (square + 0.5));
            const Bool is_even = dot(even, even) < dot(odd, odd);
            const vec2 way = named("way", select(is_even, even, odd));
            const vec2 cell = named("cell", select(is_even, 2 * corner, 2 * square + 1));
            const vec2 side = named("side", abs(way));
            const Float edge = named("edge", dot(side, vec2(0.5, sin_60())));
            const Float inside = named("inside", 0.5 - max(side.x(), edge));
            const Edges edges{mortar, bevel, footprint(p)};
            const CellAt at{cell, way, vec2(1, 1.1547005383792517), inside, edges.footprint};
            const Float lost = lost_slope(p, edges.lost(edges.grooves(vec2(1))));
            return std::tuple_cat(
                relief_of(edges.tile(inside, edges.mean(vec2(1))) + lost, amplitude),
                cell_values(at, uv, scale, seed));
        }),

    // The bump of M. Bailey's Surface Local Coordinates: in the middle of each square cell of
    // (s, t) a pyramid with four flat sides, which join on the diagonals, and a flat border.
    relief(
        pattern_on_uv("pyramids", "Pyramids",
                      "A four-sided pyramid in the middle of each cell of a grid, flat around it.",
                      "density", 8, "Pyramids per uv unit")
            .in<Float>("base", 0.5,
                       "Width of a pyramid, in cells: 0.5 leaves a quarter flat on "
                       "each side",
                       slider(0.2, 1), limits(0.01, 1)),
        0.02, "1 at the tips, 0 on the border")
        .body([](vec2 uv, Float density, Float base, Float amplitude) {
            const vec2 p = named("p", uv * density), way = named("way", p - floor(p) - 0.5);
            const vec2 side = named("side", abs(way));
            const Float value = saturate(named("rise", 1 - 2 * max(side.x(), side.y()) / base));
            const Float near = fade(footprint(p));
            // Slopes of 2 / base, on base^2 of the area, half of it along each axis.
            const Float lost = lost_slope(p, 2 * base * base * lost_share(near));
            return relief_of(mix(mean_height(base * base * (1.0 / 3)), value, near) + lost,
                             amplitude);
        }),

    cell_outputs(
        relief(
            pattern_on_uv(
                "domes", "Domes",
                "Round bumps in a grid, like rivets or studs: caps of a sphere, up to nearly "
                "half of it.",
                "scale", 6, "Domes per uv unit")
                .in<Float>("base", 0.7, "Diameter of a dome, in cells", slider(0.2, 1),
                           limits(0.01, 1))
                .in<Float>("roundness", 0.8, "The profile: near 1 a hemisphere, near 0 a parabola",
                           slider(0.1, 0.95), limits(0.05, 0.999))
                .in<Float>("stagger", 0,
                           "How far each row is moved against the one below, in cells",
                           slider(0, 1))
                .count("seed", 0, 0, 65535, seed_doc),
            0.01, "1 at the tops, 0 around the domes"))
        .body([](vec2 uv, Float scale, Float base, Float roundness, Float stagger, int seed,
                 Float amplitude) {
            const vec2 p = named("p", uv * scale);
            const Float row = named("row", floor(p.y()));
            const Float x = named("x", p.x() - row * stagger);
            const vec2 cell = named("cell", vec2(floor(x), row));
            const vec2 way = named("way", vec2(x, p.y()) - cell - 0.5);
            const Float radius = 0.5 * base;
            const Float square = roundness * roundness;
            const Float rim = sqrt(1 - square);
            const Float apart = named("apart", dot(way, way) / (radius * radius));
            const Float cap = named("cap", sqrt(1 - square * min(apart, 1)));
            const Float value = (cap - rim) / (1 - rim);
            // The mean over the disc: the integral of the square root, less the rim.
            const Float disc = (2.0 / 3) * (1 - rim * rim * rim) / square - rim;
            const Float mean = pi() * radius * radius * disc / (1 - rim);
            const Float width = footprint(p), edge = radius - length(way);
            const Float near = fade(width);
            const Float sloped = pi() * radius * radius;
            // Half the integral of the square of the cap's slope over the disc.
            const Float slopes = -0.5 * pi() * (square + log(1 - square)) / ((1 - rim) * (1 - rim));
            const Float lost = lost_slope(p, slopes * sloped * lost_share(near));
            return std::tuple_cat(relief_of(mix(mean_height(mean), value, near) + lost, amplitude),
                                  cell_values({cell, way, vec2(1), edge, width}, uv, scale, seed));
        })};
constinit std::span<Node> pattern_nodes = pattern_list;

}  // namespace wrinkle::nodes

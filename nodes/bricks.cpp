// Walls and pavements of bricks in the usual bonds, with random numbers of each brick.
#include <span>

#include "nodes/cells.h"
#include "nodes/tile_edges.h"

namespace wrinkle::nodes {
using namespace sdk;

enum class Bond { running, english, flemish, planks, herringbone, basket_weave, spanish };

struct Bricks {
    vec2 uv;
    Float scale;
    Choice bond;
    Float aspect, offset;
    int every;
    Float variation, mortar, bevel, radius;
    int seed;
    Float amplitude;
};

// A brick at a position: (number, row) or its lower left corner, and the rest of CellAt. A row has
// height 1.
struct Brick {
    vec2 cell, way, size;
};
static Brick at_corner(vec2 p, vec2 corner, vec2 size) {
    return {corner, p - corner - 0.5 * size, size};
}
static Brick in_row(Float x, Float y, Float row, Float length) {
    const Float column = named("column", floor(x / length));
    return {{column, row}, {x - (column + 0.5) * length, y}, {length, 1}};
}

// Boards of random lengths: joint k of a row is near k lengths, by at most half of `variation`.
static Brick plank(Float x, Float y, Float row, const Bricks& in) {
    const auto joint = [&](Float k) {
        const Float random = unit_float(random_bits(vec2(k, row), 1, in.seed));
        return (k + in.variation * (random - 0.5)) * in.aspect;
    };
    const Float nearest = named("nearest", floor(x / in.aspect + 0.5));
    const Float k = named("k", nearest - Float(x < joint(nearest)));
    const Float start = named("start", joint(k)), end = named("end", joint(k + 1));
    return {{k, row}, {x - 0.5 * (start + end), y}, {end - start, 1}};
}

// Rows of stretchers with headers of half their length: alternating rows, or both in every row.
static Brick row_of(Bond bond, vec2 p, const Bricks& in) {
    const Float aspect = in.aspect;
    const Float row = named("row", floor(p.y())), y = named("y", p.y() - row - 0.5);
    const Float odd = named("odd", mod(row, 2));
    const Float steps = in.every == 0 ? row : Float(mod(row + 0.5, in.every) < 1);
    const Float moved = p.x() - steps * in.offset * aspect;
    if (bond == Bond::running) return in_row(moved, y, row, aspect);
    if (bond == Bond::planks) return plank(moved, y, row, in);
    if (bond == Bond::english)
        return in_row(p.x() - 0.25 * odd * aspect, y, row,
                      named("length", aspect * (1 - 0.5 * odd)));
    const Float period = named("period", 1.5 * aspect);
    const Float x = named("x", p.x() - 0.5 * odd * period);
    const Float pair = named("pair", floor(x / period)),
                in_pair = named("in_pair", x - pair * period);
    const Bool header = in_pair > aspect;
    const Float middle = named("middle", select(header, 1.25 * aspect, 0.5 * aspect));
    return {{2 * pair + Float(header), row},
            {in_pair - middle, y},
            {select(header, 0.5 * aspect, aspect), 1}};
}

// Four bricks, each from a corner of a block to the next brick, around a square of bricks less one.
static Brick pinwheel(vec2 p, vec2 square, Float squares) {
    const Float block_size = named("block_size", squares + 1);
    const vec2 block = named("block", floor(square / block_size + 0.5 / block_size) * block_size);
    const vec2 inner = named("inner", square - block);
    // Where an upright and a lying brick meet, the upright one has the corner.
    const Bool left = inner.x() < 0.5 && inner.y() < squares - 0.5;
    const Bool right = inner.x() > squares - 0.5 && inner.y() > 0.5;
    const Bool low = inner.y() < 0.5;
    const Bool high = inner.y() > squares - 0.5;
    const Bool upright = named("upright", left || right), lying = named("lying", low || high);
    const vec2 first = select(upright, vec2(select(left, 0, squares), select(left, 0, 1)),
                              vec2(select(low, 1, 0), select(low, 0, squares)));
    const Bool outer = upright || lying;
    const vec2 side = select(upright, vec2(1, squares), vec2(squares, 1));
    return at_corner(p, block + select(outer, first, vec2(1)),
                     select(outer, side, vec2(squares - 1)));
}

// Bricks along both axes, of a whole number of squares: `squares` by 1.
static Brick crossed(Bond bond, vec2 p, Float squares) {
    const vec2 lying(squares, 1), upright(1, squares), square = named("square", floor(p));
    if (bond == Bond::basket_weave) {
        const vec2 block = named("block", floor(p / squares)), corner = block * squares;
        const Bool vertical = mod(block.x() + block.y(), 2) > 0.5;
        const vec2 stripe = square - corner;
        return at_corner(p, corner + select(vertical, vec2(stripe.x(), 0), vec2(0, stripe.y())),
                         select(vertical, upright, lying));
    }
    if (bond == Bond::spanish) return pinwheel(p, square, squares);
    const Float k = named("k", mod(square.x() - square.y(), 2 * squares));
    const Bool horizontal = k < squares;
    const vec2 back = select(horizontal, vec2(k, 0), vec2(0, 2 * squares - 1 - k));
    return at_corner(p, named("corner", square - back), select(horizontal, lying, upright));
}

static CellAt brick_at(const Bricks& in, vec2 p) {
    const Bond bond = in.bond;
    const Brick brick = bond < Bond::herringbone
                            ? row_of(bond, p, in)
                            : crossed(bond, p, named("squares", floor(in.aspect + 0.5)));
    const vec2 way = named("way", brick.way), size = named("size", brick.size);
    const vec2 half = named("extent", 0.5 * size - 0.5 * in.mortar);
    const Float radius = named("radius", clamp(in.radius, 0, max(min(half.x(), half.y()), 0)));
    const vec2 corner = named("from_corner", abs(way) - half + radius);
    const Float outside = length(max(corner, 0)) + min(max(corner.x(), corner.y()), 0);
    return {brick.cell, way, size, named("edge", radius - outside), footprint(p)};
}

// Returns the mean over the area of the bond of a quantity of each size of brick.
template <class Of>
static auto mean_over(const Bricks& in, Of of) {
    const Bond bond = in.bond;
    if (bond == Bond::spanish) {  // four bricks around a square, in a block
        const Float squares = named("squares", floor(in.aspect + 0.5));
        const Float side = squares - 1, block = squares + 1;
        return (4 * squares * of(vec2(squares, 1)) + side * side * of(vec2(max(side, 0.5)))) /
               (block * block);
    }
    const auto stretchers = of(vec2(in.aspect, 1));
    if (bond != Bond::english && bond != Bond::flemish) return stretchers;
    const double headers = bond == Bond::english ? 0.5 : 1.0 / 3;
    return mix(stretchers, of(vec2(0.5 * in.aspect, 1)), headers);
}

static Float filtered_height(const Bricks& in, vec2 p, const CellAt& at) {
    const Edges edges{in.mortar, in.bevel, at.width};
    const Float mean = mean_over(in, [&](vec2 size) { return edges.mean(size); });
    const vec2 lying = mean_over(in, [&](vec2 size) { return edges.grooves(size); });
    const Bond bond = in.bond;
    const vec2 grooves = bond < Bond::herringbone ? lying : 0.5 * (lying + lying.yx());
    return edges.tile(at.edge + 0.5 * in.mortar, mean) + lost_slope(p, edges.lost(grooves));
}

static constinit Node bricks_list[] = {
    cell_outputs(
        relief(
            with_edges(
                pattern_on_uv("bricks", "Bricks in bonds",
                              "A wall or a pavement of bricks with numbers of each brick; bonds of "
                              "rows or of crossed bricks.",
                              "scale", 6, "Widths of a brick per uv unit")
                    .choice(
                        "bond",
                        {"running", "english", "flemish", "planks", "herringbone", "basket_weave",
                         "spanish"},
                        "Rows moved by the offset; rows of halves between; halves in every row; "
                        "boards of random lengths; or crossed bricks, of a rounded aspect: spanish "
                        "has four around a square")
                    .in<Float>("aspect", 2, "Length of a brick over its width", slider(1, 6),
                               limits(1, 100), unit("x"))
                    .in<Float>("offset", 0.5,
                               "How far each row of running and planks is moved, in bricks",
                               slider(0, 1))
                    .count("every", 0, 0, 16,
                           "0 moves each row against the one below, n only every nth row")
                    .in<Float>("variation", 0.7, "How different the lengths of planks are",
                               slider(0, 0.9), limits(0, 0.9)),
                0.06, 0.1, "Width of the mortar's bottom, in widths of a brick")
                .in<Float>("radius", 0, "Radius of the corners, likewise", slider(0, 0.5),
                           limits(0, 1e6))
                .count("seed", 0, 0, 65535, seed_doc),
            0.008, "1 on a brick, 0 in the mortar"))
        .body([](Bricks in) {
            const vec2 p = named("p", in.uv * in.scale);
            const CellAt at = brick_at(in, p);
            return std::tuple_cat(relief_of(filtered_height(in, p, at), in.amplitude),
                                  cell_values(at, in.uv, in.scale, in.seed));
        })};
constinit std::span<Node> bricks_nodes = bricks_list;

}  // namespace wrinkle::nodes

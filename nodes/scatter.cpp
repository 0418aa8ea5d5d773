// Many copies of a shape, or of a graph, on a uv set: in a grid or at random positions.
//
// Each point looks at the copies within a reach. A copy that reaches farther is drawn smaller, so
// none is cut. A loop finds the copy on top, which is drawn once more after it: a slope is
// differentiated once. Far away the value fades to a mean.
#include <span>

#include "nodes/cells.h"
#include "nodes/constants.h"

namespace wrinkle::nodes {
using namespace sdk;

enum class Stamp { dome, disc, box, pattern };
enum class Order { max, add, random, by_height };

// The value of a field without a wire.
struct unwired {
    double value;
    explicit constexpr unwired(double everywhere) : value(everywhere) {}
    constexpr void apply(wr_port& port) const { set_default(port, Default(value)); }
};

struct Copies {
    vec2 uv, dx, dy;  // with its screen differentials, which no loop can take
    Float pixel;      // their length
    Field<Float> pattern, mask;
    Stamp stamp;
    Float bevel;
    vec2 size;  // in uv units, before random numbers
    Float size_random, rotation, rotation_random, height_random, density;
    Order order;
    int seed;
};

struct Copy {
    vec2 position;  // two random numbers
    vec2 turn;      // cosine and sine of its rotation
    vec2 size;      // in uv units
    Float height;
    Float chance;  // it is drawn where the density is above

    // Converts a vector from its middle, in uv units, to its own coordinates from -0.5 to 0.5.
    vec2 own(vec2 way) const {
        return vec2(dot(turn, way), way.y() * turn.x() - way.x() * turn.y()) / size;
    }
};

// `reach`: the greatest half extents, in uv units.
static Copy copy_of(const Copies& in, vec2 cell, vec2 reach) {
    const auto copy = function("copy_of(cell, size, reach)", [&](vec2 cell, vec2 size, vec2 reach) {
        const vec3 random = named("random", random3(random_bits(cell, 1, in.seed)));
        const vec3 look = named("look", random3(random_bits(cell, 2, in.seed)));
        const Float turns = in.rotation_random * (2 * random.z() - 1);
        const Float angle = named("angle", radians(in.rotation + turns));
        const vec2 turn = named("turn", vec2(cos(angle), sin(angle))), side = abs(turn);
        const vec2 wanted = named("wanted", size * (1 - in.size_random * look.x()));
        const vec2 extent = 0.5 * vec2(dot(side, wanted), dot(side, wanted.yx()));
        const vec2 room = named("room", reach / extent);
        const Float height = 1 - in.height_random * look.y();
        return std::tuple{random.xy(), turn, wanted * min(1, min(room.x(), room.y())),
                          vec2(height, look.z())};
    });
    const auto [position, turn, size, rest] = copy(cell, in.size, reach);
    return {position, turn, size, rest.x(), rest.y()};
}

// A value and the covered part of the pixel, 0 to 1.
struct Drawn {
    Float value, coverage;
};

// A stamp at its own coordinates, its edges blurred by the pixel. One smaller than a pixel is drawn
// as large as the pixel and lower, so that the mean stays.
static Drawn stamp_at(const Copies& in, const Copy& copy, vec2 own) {
    const Float longer = max(length(copy.own(in.dx)), length(copy.own(in.dy)));
    const Float pixel = named("pixel", detach(max(longer, 1e-6)));
    const Float grown = named("grown", max(pixel, 1)), width = named("width", min(pixel, 1));
    const Float thin = 1 / (grown * grown);
    const vec2 at = named("at", own / grown);
    const bool round = in.stamp == Stamp::dome || in.stamp == Stamp::disc;
    const Float edge = named("edge", 0.5 - (round ? length(at) : max(abs(at.x()), abs(at.y()))));
    const Float coverage = named("coverage", saturate(edge / width + 0.5) * thin);
    if (in.stamp == Stamp::dome) return {max(1 - 4 * dot(at, at), 0) * thin, coverage};
    if (in.stamp == Stamp::pattern) return {in.pattern(at + 0.5) * coverage, coverage};
    const Float rise = (edge - 0.5 * in.bevel) / max(in.bevel, width);
    return {saturate(rise + 0.5) * thin, coverage};
}

// Copies in a grid with cells of size 1 / amount.
struct CopyGrid {
    vec2 uv, amount;
    Float jitter, row_offset;
    int ring;  // neighbours on each side of the own cell

    uint32_t count() const { return static_cast<uint32_t>((2 * ring + 1) * (2 * ring + 1)); }
    vec2 reach() const { return (ring + 0.5 - 0.5 * jitter) / amount; }
    vec2 near(vec2 step) const {
        const vec2 p = named("p", uv * amount);
        const Float row = named("row", floor(p.y()) + step.y());
        return vec2(floor(p.x() - row * row_offset) + step.x(), row);
    }
    vec2 cell(Int index) const { return near(offset2(index, 2 * ring + 1)); }
    vec2 first() const { return near(vec2(0)); }
    vec2 middle(vec2 cell, vec2 random) const {
        const vec2 moved = jitter * (random - 0.5) + vec2(cell.y() * row_offset, 0);
        return (cell + 0.5 + moved) / amount;
    }
    vec2 from(vec2 middle) const { return uv - middle; }
    Float per_area() const { return amount.x() * amount.y(); }
    Float width() const { return footprint(uv * amount); }
    Float covered(Float areas, double) const { return min(areas, 1); }
};

// Copies at random positions of the unit square, which repeats.
struct CopySquare {
    vec2 uv, size;
    int copies;

    uint32_t count() const { return static_cast<uint32_t>(copies); }
    vec2 reach() const { return vec2(0.5); }
    vec2 cell(Int index) const { return vec2(Float(index), 0); }
    vec2 first() const { return vec2(0); }
    vec2 middle(vec2, vec2 random) const { return random; }
    vec2 from(vec2 middle) const { return fract(uv - middle + 0.5) - 0.5; }
    Float per_area() const { return Float(copies); }
    Float width() const { return footprint(uv / size); }
    // Copies of random positions overlap: those that cover a point have a Poisson distribution.
    Float covered(Float areas, double part) const { return (1 - exp(-part * areas)) / part; }
};

// The copy of a cell at the point, if it is drawn there.
struct Placed {
    Copy copy;
    vec2 middle, own;
    Drawn drawn;
};
template <class Places>
static Placed placed(const Copies& in, const Places& places, vec2 cell) {
    const vec2 reach = places.reach();
    const Copy copy = copy_of(in, cell, max(reach - 0.5 * in.pixel, 0.25 * reach));
    const vec2 middle = named("middle", places.middle(cell, copy.position));
    const vec2 own = named("own", copy.own(places.from(middle)));
    const auto [value, coverage] = stamp_at(in, copy, own);
    return {copy, middle, own, {value * copy.height, coverage}};
}
template <class Places>
static Placed thinned(const Copies& in, const Places& places, vec2 cell) {
    const Placed at = placed(in, places, cell);
    const Bool there = named("there", at.copy.chance < in.density * in.mask(at.middle));
    return {at.copy,
            at.middle,
            at.own,
            {select(there, at.drawn.value, 0), select(there, at.drawn.coverage, 0)}};
}

// The copy with the greatest rank above 0 is on top. A pixel of an edge counts as one of the copy
// if the copy covers half of it.
static Float rank_of(const Copies& in, vec2 cell, const Placed& at) {
    const auto [value, coverage] = at.drawn;
    if (in.order == Order::max || in.order == Order::add) return value;
    const Float chance = unit_float(random_bits(cell, 3, in.seed));
    const Float rank = in.order == Order::random ? chance : at.copy.height + chance * (1.0 / 1024);
    const Bool drawn =
        abs(value) > named("least_drawn // smaller patterns count as 0", Float(1e-5));
    return select(drawn, select(coverage >= 0.5, 1 + rank, coverage), 0);
}

struct Top {
    vec2 cell;
    Bool any;
    Float coverage;  // by any copy
};
template <class Places>
static Top top_of(const Copies& in, const Places& places) {
    const auto [k, rank, cell, covered] = loop(
        "copies(k, highest, top, covered)", places.count(),
        std::tuple{Int(0), Float(0), places.first(), Float(0)},
        [&](Int k, Float highest, vec2 top, Float covered) {
            const vec2 cell = named("cell", places.cell(k));
            const Placed at = thinned(in, places, cell);
            const Float rank = named("rank", rank_of(in, cell, at));
            return std::tuple{Bool(true), k + 1, max(rank, highest),
                              select(rank > highest, cell, top), max(covered, at.drawn.coverage)};
        });
    return {detach(cell), rank > 0, covered};
}

// A loop reads a field with the footprint of the surface, not of the copy: so patterns are added
// without one.
template <class Places>
static Float sum_of(const Copies& in, const Places& places) {
    std::tuple sum{Int(0), Float(0)};
    const auto add = [&](Int k, Float sum) {
        const Placed at = thinned(in, places, named("cell", places.cell(k)));
        return std::tuple{Bool(true), k + 1, sum + at.drawn.value};
    };
    if (in.stamp != Stamp::pattern)
        sum = loop("copies(k, sum)", places.count(), sum, add);
    else
        for (uint32_t k = 0; k < places.count(); ++k) {
            const auto [more, next, value] = std::apply(add, sum);
            sum = {next, value};
        }
    return std::get<1>(sum);
}

// The mean over one stamp, and the part of its box that it covers.
static Float stamp_mean(const Copies& in) {
    const Float inner = 1 - 2 * in.bevel, frustum = (1 + inner + inner * inner) / 3;
    switch (in.stamp) {
        case Stamp::dome:
            return pi() / 8;
        case Stamp::disc:
            return pi() / 4 * frustum;
        case Stamp::box:
            return frustum;
        default:
            return in.pattern(0.5 + (in.uv - detach(in.uv)) / in.size);
    }
}
template <class Places>
static Drawn mean_of(const Copies& in, const Places& places) {
    const bool round = in.stamp == Stamp::dome || in.stamp == Stamp::disc;
    const double part = round ? 0.7853981633974483 : 1;
    const Float smaller = 1 - in.size_random * (1 - in.size_random / 3);  // mean area
    const Float areas = max(
        places.per_area() * in.size.x() * in.size.y() * smaller * in.density * in.mask(in.uv), 0);
    const Float covered = places.covered(areas, part);
    const Float drawn = in.order == Order::add ? areas : covered;
    const Float height = 1 - 0.5 * in.height_random;
    return {mean_height(detach(drawn * stamp_mean(in) * height)), detach(covered * part)};
}

template <class Places>
static auto scattered(const Copies& in, const Places& places, Float amplitude) {
    const auto [cell, any, coverage] = top_of(in, places);
    const Placed top = placed(in, places, cell);
    const Float value =
        in.order == Order::add ? sum_of(in, places) : select(any, top.drawn.value, 0);
    const Drawn far = mean_of(in, places);
    const Float detail = fade(places.width());
    return std::tuple_cat(relief_of(mix(far.value, value, detail), amplitude),
                          std::tuple{mix(far.coverage, coverage, detail), top.own + 0.5, cell,
                                     random3(random_bits(cell, 0, in.seed)), detach(top.middle),
                                     detail, detach(top.copy.turn)});
}

// Adds the first ports, and after those of positions the last ones.
static constexpr auto scatter_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc)
        .family("scatter")
        .in<vec2>("uv", surface::uv0, "Where to read it, on any uv set")
        .field<Float>("pattern", surface::uv0,
                      "For the shape `pattern`: a graph made from uv0, read from 0 to 1 across a "
                      "copy; an edge that is not 0 is cut off by a pixel's width",
                      unwired(1))
        .field<Float>("mask", surface::uv0,
                      "A factor of the density, made from uv0, read in the middle of each copy",
                      unwired(1))
        .choice("shape", {"dome", "disc", "box", "pattern"},
                "The shape of a copy, or the graph that is wired to `pattern`")
        .in<Float>("bevel", 0.2,
                   "Width of the slope of a disc or box, in copies: 0.5 is a cone or pyramid",
                   slider(0, 0.5), limits(0, 0.5));
}
template <class Declaration>
static constexpr auto copies(const Declaration& declaration) {
    return relief(declaration
                      .template in<Float>("rotation", 0, "Angle of the copies, anticlockwise",
                                          slider(-180, 180), unit("deg"))
                      .template in<Float>("rotation_random", 0,
                                          "How far copies turn at random, both ways",
                                          slider(0, 180), unit("deg"))
                      .template in<Float>("height_random", 0, "How much lower some copies are",
                                          slider(0, 1), limits(0, 1))
                      .template in<Float>("density", 1, "The part of the copies that is drawn",
                                          slider(0, 1), limits(0, 1))
                      .choice("order", {"max", "add", "random", "by_height"},
                              "Where copies overlap: the greatest value, the sum, or one copy on "
                              "top, at random or the highest")
                      .count("seed", 0, 0, 65535, seed_doc),
                  0.01, "0 to 1 times the height of the copy, 0 between copies")
        .template out<Float>("mask", "1 on a copy, 0 between copies")
        .template out<vec2>("uv", "0 to 1 across the copy on top, with the slopes of the uv")
        .template out<vec2>("cell", "The copy on top: whole numbers, for random nodes")
        .template out<vec3>("random", "Three random numbers of that copy, 0 to below 1")
        .template out<vec2>("center", "The middle of that copy, on the uv set")
        .template out<Float>("detail", "1 near, 0 where a pixel covers a copy")
        .template out<vec2>("direction",
                            "Along the u of the copy on top, in uv: unit, for tangents");
}

struct TileSampler {
    vec2 uv;
    Field<Float> pattern, mask;
    Stamp shape;
    Float bevel;
    vec2 amount, scale;
    Float scale_random, position_random, row_offset;
    bool wide;
    Float rotation, rotation_random, height_random, density;
    Order order;
    int seed;
    Float amplitude;
};

struct Splatter {
    vec2 uv;
    Field<Float> pattern, mask;
    Stamp shape;
    Float bevel;
    int count;
    vec2 size;
    Float size_random, rotation, rotation_random, height_random, density;
    Order order;
    int seed;
    Float amplitude;
};

template <class In>
static Copies copies_of(const In& in, vec2 size, Float size_random) {
    return {in.uv,
            ddx(in.uv),
            ddy(in.uv),
            footprint(in.uv),
            in.pattern,
            in.mask,
            in.shape,
            in.bevel,
            size,
            size_random,
            in.rotation,
            in.rotation_random,
            in.height_random,
            in.density,
            in.order,
            in.seed};
}

static constinit Node scatter_list[] = {
    copies(scatter_family("tile_sampler", "Tile sampler",
                          "Copies of a shape or of a graph in a grid, each moved, turned and "
                          "scaled at random.")
               .in<vec2>("amount", 8, "Copies per uv unit", slider(1, 64), limits(1e-3, 1e6))
               .in<vec2>("scale", 1, "Size of a copy, in cells", slider(0.05, 2), limits(1e-3, 1e3))
               .in<Float>("scale_random", 0, "How much smaller some copies are", slider(0, 1),
                          limits(0, 1))
               .in<Float>("position_random", 0, "How far copies move at random, in cells",
                          slider(0, 1), limits(0, 1))
               .in<Float>("row_offset", 0,
                          "How far each row is moved against the one below, in cells", slider(0, 1))
               .flag("wide", false,
                     "Looks at 25 instead of 9 copies. Copies larger than fit are drawn smaller: "
                     "half of a copy and of its move reaches 1.5 cells, or 2.5 if wide"))
        .body([](TileSampler in) {
            const Copies copies = copies_of(in, in.scale / in.amount, in.scale_random);
            const CopyGrid grid{in.uv, in.amount, in.position_random, in.row_offset,
                                in.wide ? 2 : 1};
            return scattered(copies, grid, in.amplitude);
        }),

    copies(scatter_family("splatter", "Splatter",
                          "Copies of a shape or of a graph at random positions of the unit "
                          "square, which repeats without seams. Every copy costs everywhere.")
               .count("count", 16, 1, 64, "How many copies there are")
               .in<vec2>("size", 0.25,
                         "Width and height of a copy, in uv units; its extent is at "
                         "most 1",
                         slider(0.01, 1), limits(1e-4, 1e3))
               .in<Float>("size_random", 0, "How much smaller some copies are", slider(0, 1),
                          limits(0, 1)))
        .body([](Splatter in) {
            const Copies copies = copies_of(in, in.size, in.size_random);
            return scattered(copies, CopySquare{in.uv, in.size, in.count}, in.amplitude);
        })};
constinit std::span<Node> scatter_nodes = scatter_list;

}  // namespace wrinkle::nodes

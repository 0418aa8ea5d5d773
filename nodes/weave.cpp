// Cloth as a relief, with numbers of each thread: warp threads are along v, one in each unit of u,
// weft threads along u.
#include <span>

#include "nodes/cells.h"
#include "nodes/constants.h"

namespace wrinkle::nodes {
using namespace sdk;

enum class Weave { plain, twill, twill_3_1, satin_5, satin_8 };

struct Cloth {
    vec2 uv;
    Float scale;
    Choice weave;
    Float width;
    int seed;
    Float amplitude;
};

// True if the warp is above at a crossing. Halves are added since mod is inexact at its ends.
static Bool warp_is_above(Weave weave, Float column, Float row) {
    switch (weave) {
        case Weave::plain:
            return mod(column + row + 0.5, 2) < 1;
        case Weave::twill:
            return mod(column - row + 0.5, 4) < 2;
        case Weave::twill_3_1:
            return mod(column - row + 0.5, 4) < 3;
        case Weave::satin_5:
            return mod(2 * column - row + 0.5, 5) > 1;
        default:
            return mod(3 * column - row + 0.5, 8) > 1;
    }
}
// 1 where the warp is above, -1 where the weft is.
static auto warp_side_function(Weave weave) {
    return function("warp_side(column, row)", [weave](Float column, Float row) {
        return select(warp_is_above(weave, column, row), 1, -1);
    });
}

// Height of threads along y: round across, highest above a crossing and 0.35 of that below one,
// by a cosine between two crossings.
static auto thread_function() {
    return function("thread(p, width, side, next)",
                    [](vec2 p, Float width, Float side, Float next) {
                        const Float lane = floor(p.x()), crossing = p.y() - 0.5;
                        const Float across = (2 * (p.x() - lane) - 1) / width;
                        const Float way = cos((crossing - floor(crossing)) * pi());
                        const Float above = mix(next, side, 0.5 + 0.5 * way);
                        return max(1 - across * across, 0) * (0.675 + 0.325 * above);
                    });
}

struct Threads {
    Float warp, weft;  // heights
};
static Threads threads_at(Weave weave, vec2 p, Float width) {
    const auto thread = thread_function();
    const vec2 lane = named("lane", floor(p)), crossing = named("crossing", floor(p - 0.5));
    const auto at = warp_side_function(weave);
    const Float x = lane.x(), y = lane.y(), from_x = crossing.x(), from_y = crossing.y();
    return {named("warp", thread(p, width, at(x, from_y), at(x, from_y + 1))),
            named("weft", thread(p.yx(), width, -at(from_x, y), -at(from_x + 1, y)))};
}

// Measured over a period and fitted: the mean of the higher thread's height, the share of the plane
// where it is the warp, and the variances of its slope across warp and weft threads.
struct ClothMeans {
    Float height, warp;
    vec2 slopes;
};
static ClothMeans means_of(Weave weave, Float width) {
    const auto fitted = [&](double a, double b, double warp, vec2 steep, vec2 flat) {
        return ClothMeans{width * (a + b * width), 0.5 + warp * (width * width),
                          steep / width - flat};
    };
    switch (weave) {
        case Weave::plain:
            return fitted(0.917, -0.271, 0, vec2(3.26), vec2(1.99));
        case Weave::twill:
            return fitted(0.9134, -0.2483, 0, vec2(3.28), vec2(1.79));
        case Weave::twill_3_1:
            return fitted(0.9131, -0.2479, 0.187, {4.56, 1.94}, {2.18, 1.29});
        case Weave::satin_5:
            return fitted(0.9107, -0.2419, 0.225, {4.84, 1.68}, {2.27, 1.15});
        default:
            return fitted(0.9068, -0.2323, 0.281, {5.18, 1.29}, {2.23, 0.95});
    }
}

// The share of the warp where threads are lost. The diagonals of a twill are four threads wide and
// stay longer: the first harmonic, measured and fitted as the means are.
struct Share {
    Float far, near;  // near is the weight of the threads
};
static Share share_of(Weave weave, vec2 p, Float width, Float mean, Float footprint) {
    if (weave != Weave::twill && weave != Weave::twill_3_1) return {mean, fade(footprint)};
    const bool even = weave == Weave::twill;
    const Float strength = even ? width * (0.061 + 0.37 * width) : width * (0.043 + 0.262 * width);
    const Float diagonal = named("diagonal", 0.25 * (p.y() - p.x()));
    const Float way = fract(diagonal + (even ? 0.125 : 0.25));
    const Float wave = named("wave", fade(box_width(diagonal)) * cos(two_pi() * way));
    return {mean + strength * wave, fade(footprint, 0.75)};
}

struct Visible {
    Float over;  // 1 on the warp, 0 on the weft; filtered
    Bool warp;
};
static Visible visible_at(const Threads& threads, const Share& share) {
    const Float apart = named("apart", threads.warp - threads.weft);
    const Float width = named("edge_width", max(box_width(apart), 1e-6));
    return {mix(share.far, saturate(0.5 + apart / width), share.near), detach(apart) >= 0};
}

template <class Declaration>
static constexpr auto thread_outputs(const Declaration& declaration) {
    return declaration
        .template out<Float>("over", "1 where the warp, along v, is on top, 0 where the weft is")
        .template out<Float>("thread", "The thread on top: even numbers are the warp's")
        .template out<Float>("along",
                             "Position along this thread from crossing to crossing, 0 to 1")
        .template out<vec2>("direction", "Along this thread in uv: (0, 1) or (1, 0)")
        .template out<vec3>("tangent",
                            "Across this thread in object space, for the output `tangent`: "
                            "threads stretch highlights across themselves");
}

static constinit Node weave_list[] = {
    cell_outputs(
        thread_outputs(relief(
            pattern_on_uv("weave", "Weave",
                          "Cloth of round threads along u and v, with numbers of each thread: the "
                          "cell is the "
                          "thread on top, its center the middle of the square of the crossing.",
                          "scale", 8, "Threads per uv unit")
                .choice("weave", {"plain", "twill", "twill_3_1", "satin_5", "satin_8"},
                        "Threads in turn above and below; diagonals of two above and two below, or "
                        "three and one; or long warp threads, held at every fifth or eighth")
                .in<Float>("width", 0.9, "Width of a thread, in distances of two threads",
                           slider(0.4, 1), limits(0.3, 1))
                .count("seed", 0, 0, 65535, seed_doc),
            0.02, "1 where a thread is on top, 0 between threads")))
        .body([](Cloth in) {
            const Weave weave = in.weave;
            const vec2 p = named("p", in.uv * in.scale);
            const Threads threads = threads_at(weave, p, in.width);
            const ClothMeans means = means_of(weave, in.width);
            const Float width = footprint(p), near = fade(width);
            const Float gap = 1 - in.width, sloped = 1 - gap * gap;
            const Float lost = lost_slope(p, vec3(means.slopes * sloped * lost_share(near), 0));
            const Float value =
                mix(mean_height(means.height), max(threads.warp, threads.weft), near) + lost;
            const Visible visible =
                visible_at(threads, share_of(weave, p, in.width, means.warp, width));
            const Bool warp = visible.warp;
            const vec2 lane = named("lane", floor(p)), way = named("way", p - lane - 0.5);
            const Float number = select(warp, lane.x(), lane.y());
            const Float across = select(warp, way.x(), way.y());
            const vec2 along = select(warp, vec2(0, 1), vec2(1, 0));
            const Gradient tangent{Derivative(along.yx(), frame(in.uv, Scale::unit))};
            const CellAt at{vec2(number, Float(!warp)), way, vec2(1), 0.5 * in.width - abs(across),
                            width};
            return std::tuple_cat(
                relief_of(value, in.amplitude),
                std::tuple{visible.over, 2 * number + Float(!warp),
                           0.5 + select(warp, way.y(), way.x()), along, tangent.vector()},
                cell_values(at, in.uv, in.scale, in.seed));
        })};
constinit std::span<Node> weave_nodes = weave_list;

}  // namespace wrinkle::nodes

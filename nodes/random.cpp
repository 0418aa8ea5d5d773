// Random values by cell and by number, and colors chosen by them.
#include "nodes/random.h"

#include <span>
#include <vector>

#include "nodes/color_space.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr int most_colors = 8;
static constexpr const char* palette_colors[] = {"color_1", "color_2", "color_3", "color_4",
                                                 "color_5", "color_6", "color_7", "color_8"};
static constexpr const char* weights[] = {"weight_1", "weight_2", "weight_3", "weight_4",
                                          "weight_5", "weight_6", "weight_7", "weight_8"};
static constexpr char detail_doc[] =
    "1 is the random result, 0 the mean of all; wire the detail of cells";

static constexpr auto random_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc)
        .family("random")
        .in<vec2>("cell", 0, "The cell; rounded to whole numbers")
        .in<Float>("id", 0, "A further number, also rounded")
        .count("seed", 0, 0, 65535, "Another seed gives other numbers");
}
template <class Declaration>
static constexpr auto with_detail(const Declaration& declaration) {
    return declaration.template in<Float>("detail", 1, detail_doc, slider(0, 1), limits(0, 1));
}

struct RandomColor {
    vec2 cell;
    Float id;
    int seed;
    Float hue_low, hue_high, saturation_low, saturation_high, value_low, value_high, detail;
};

// The integral from hue 0 of the colors of saturation and value 1.
static vec3 hue_integral(Float hue) {
    const auto integral = function("hue_integral(hue)", [](Float hue) {
        const vec3 turn = named("turn", hue + vec3(0, 2.0 / 3, 1.0 / 3));
        const vec3 start = named("start", floor(turn)), sixth = named("sixth", (turn - start) * 6);
        const auto area = [](vec3 x) {
            const vec3 part = named("part", saturate(x));
            return 0.5 * part * part + max(x - 1, 0);
        };
        return 0.5 * start + (sixth - area(sixth - 1) + area(sixth - 4)) / 6;
    });
    return integral(hue);
}
static vec3 mean_of_hues(Float low, Float high) {
    const Float range = named("range", high - low);
    const Bool narrow = abs(range) < 1e-4;
    return select(narrow, from_hsv(vec3(low, 1, 1)),
                  (hue_integral(high) - hue_integral(low)) / select(narrow, 1, range));
}

struct Palette {
    Float random;
    int colors;
    struct {
        vec3 color;
        Float weight;
    } entry[most_colors];
    Float detail;
};

template <int k = 0, class Declaration>
static constexpr auto with_palette(const Declaration& declaration) {
    if constexpr (k == most_colors)
        return declaration;
    else
        return with_palette<k + 1>(
            declaration
                .template in<Color>(palette_colors[k], k % 2, "A color, linear", slider(0, 1))
                .template in<Float>(weights[k], 1, "Its share, relative to the other weights",
                                    slider(0, 1), limits(0, 1e6)));
}

static constinit Node random_list[] = {
    with_detail(
        random_family("random", "Random", "Random numbers of a cell, the same on every machine."))
        .out<Float>("value", "0 to below 1")
        .out<vec3>("vector", "Three more, 0 to below 1")
        .out<Color>("color", "The vector as a linear color")
        .body([](vec2 cell, Float id, int seed, Float detail) {
            const Uint bits = random_bits(cell, id, seed);
            const vec3 vector = mix(vec3(0.5), random3(hash(bits)), detail);
            return std::tuple{mix(0.5, unit_float(bits), detail), vector, vector};
        }),

    with_detail(random_family("random_range", "Random in a range",
                              "A random number of a cell between two bounds.")
                    .in<Float>("low", 0, "The lower bound", slider(0, 1))
                    .in<Float>("high", 1, "The upper bound", slider(0, 1)))
        .out<Float>("value", "low to high")
        .body([](vec2 cell, Float id, int seed, Float low, Float high, Float detail) {
            const Float random = unit_float(random_bits(cell, id, seed));
            return mix(low, high, mix(0.5, random, detail));
        }),

    with_detail(
        random_family("random_color", "Random color",
                      "A random color of a cell within ranges of hue, saturation and value.")
            .in<Float>("hue_low", 0, "Start of the hues, in turns", slider(0, 1))
            .in<Float>("hue_high", 1, "End of the hues, in turns", slider(0, 1))
            .in<Float>("saturation_low", 0.3, "Least saturation", slider(0, 1), limits(0, 1))
            .in<Float>("saturation_high", 0.8, "Greatest saturation", slider(0, 1), limits(0, 1))
            .in<Float>("value_low", 0.3, "Least value", slider(0, 1))
            .in<Float>("value_high", 0.9, "Greatest value", slider(0, 1)))
        .out<Color>("color", "The color, linear")
        .body([](RandomColor in) {
            const vec3 low(in.hue_low, in.saturation_low, in.value_low);
            const vec3 high(in.hue_high, in.saturation_high, in.value_high);
            const vec3 random = random3(random_bits(in.cell, in.id, in.seed));
            const vec3 middle = 0.5 * (low + high);
            const vec3 hue = named("hue", mean_of_hues(in.hue_low, in.hue_high));
            const vec3 mean = named("mean", middle.z() * mix(vec3(1), hue, middle.y()));
            return mix(mean, from_hsv(mix(low, high, random)), in.detail);
        }),

    random_family("random_direction", "Random direction",
                  "A random unit vector of a cell, evenly over the sphere.")
        .out<vec3>("vector", "Unit")
        .body([](vec2 cell, Float id, int seed) {
            const vec3 random = named("random", random3(random_bits(cell, id, seed)));
            const Float z = named("z", 1 - 2 * random.x()), r = named("r", sqrt(1 - z * z));
            const Float angle = named("angle", random.y() * two_pi());
            return vec3(r * cos(angle), r * sin(angle), z);
        }),

    with_detail(
        with_palette(
            node("palette", "Palette", "One of several colors, chosen by a random number.")
                .family("color")
                .in<Float>("random", 0, "The number, 0 to 1", slider(0, 1))
                .count("colors", 4, 2, most_colors, "How many colors are used, from the first")))
        .out<Color>("color", "The color; the last one if all weights are 0")
        .body([](Palette in) {
            Float total = in.entry[0].weight;
            vec3 sum = in.entry[0].color * total;
            std::vector<Float> ends{total};
            for (int k = 1; k < in.colors; ++k) {
                total += in.entry[k].weight;
                sum += in.entry[k].color * in.entry[k].weight;
                ends.push_back(total);
            }
            vec3 color = in.entry[0].color;
            const Float at = named("at", in.random * total);
            for (int k = 1; k < in.colors; ++k)
                color = select(at >= ends[static_cast<size_t>(k) - 1], in.entry[k].color, color);
            return mix(divide(sum, total), color, in.detail);
        })};
constinit std::span<Node> random_nodes = random_list;

}  // namespace wrinkle::nodes

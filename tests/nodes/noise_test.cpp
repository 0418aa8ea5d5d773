// Tests of noises: range, smoothness, random points and the sum of octaves.
#include <gtest/gtest.h>

#include <algorithm>

#include "graph/subgraph.h"
#include "nodes/relief.h"
#include "nodes/solid.h"

namespace wrinkle::test {
namespace {

struct Range {
    const char* type;
    const char* in;
    double low = 0, high = 0;  // bounds that are never exceeded
    double mean = 0, rms = 0;  // at random positions, from a separate sampling of the definition
};

void PrintTo(const Range& range, std::ostream* out) {
    *out << range.type << " {" << range.in << "}";
}

class NoiseRange : public ::testing::TestWithParam<Range> {};

// The points are on the plane z = 0 of the lattice, where noises vary a little more.
TEST_P(NoiseRange, IsKeptAndFilled) {
    const Range& range = GetParam();
    const auto noise = value_of(range.type, range.in, random_cells(20000, 400));
    double sum = 0, squares = 0;
    for (const double v : noise) {
        EXPECT_GE(v, range.low);
        EXPECT_LE(v, range.high);
        sum += v, squares += v * v;
    }
    EXPECT_NEAR(sum / 20000, range.mean, 0.02);
    EXPECT_NEAR(std::sqrt(squares / 20000), range.rms, 0.02 + 0.05 * range.rms);
}

// clang-format off
const Range ranges[] = {
    {"simplex_noise", "", -1.02, 1.02, 0, 0.388},
    {"value_noise", "", -1, 1, 0, 0.453},
    {"worley_noise", "", 0, 1.3, 0.530, 0.560},
    {"worley_noise", R"("distance": "f2")", 0, 1.4, 0.716, 0.732},
    {"worley_noise", R"("distance": "f2_minus_f1")", 0, 1.1, 0.186, 0.240},
    {"fbm", R"("octaves": 1, "basis": "value")", -1, 1, 0, 0.453},
    {"turbulence", R"("octaves": 1, "basis": "simplex")", 0, 1.02, 0.311, 0.388},
    {"ridged", R"("octaves": 1, "basis": "simplex")", 0, 1.02, 0.529, 0.601},
    {"dents", "", -1, 0, -0.012, 0.04},
};
// clang-format on
INSTANTIATE_TEST_SUITE_P(Noises, NoiseRange, ::testing::ValuesIn(ranges));

// Value and slope are continuous along a line through many cells: a step of a thousandth of a cell
// changes the slope by at most a thousandth of the maximum curvature.
TEST(SmoothNoise, HasAContinuousSlope) {
    for (const char* type : {"simplex_noise", "value_noise", "gradient_noise"}) {
        const std::string in =
            std::string(type) == "gradient_noise" ? R"("octaves": 1)" : std::string();
        std::vector<Point> line;
        for (int i = 0; i < 20000; ++i)
            line.push_back({-7 + i * 8e-4, 3 + i * 6e-4});
        const Reading noise = read(type, in, line);
        for (size_t i = 1; i < line.size(); ++i) {
            ASSERT_LE(std::fabs(noise.value[i] - noise.value[i - 1]), 0.006) << type << " at " << i;
            for (size_t k = 0; k < 2; ++k)
                ASSERT_LE(std::fabs(noise.slope[i][k] - noise.slope[i - 1][k]), 0.05)
                    << type << " at " << i;
        }
    }
}

// Slopes are output next to the values: along two tangents of a sphere they equal central
// differences of the value.
class NoiseSlope : public ::testing::TestWithParam<Range> {};

TEST_P(NoiseSlope, IsThatOfItsValue) {
    constexpr double step = 1e-6;
    const std::string in = GetParam().in;
    const std::string nodes =
        one(GetParam().type, R"("scale": 3, "amplitude": 1)" + (in.empty() ? "" : ", " + in)) +
        R"(, "g": {"type": "gradient_from_height", "in": {"height": {"from": "n.height"}}})";
    const std::vector<Place> places = on_sphere(300);
    const auto slopes = values_on({nodes, "g.gradient"}, places, 1e-4);
    for (const Vector along : {Vector{0.3, 0.8, -0.5}, Vector{-0.7, 0.1, 0.4}}) {
        std::vector<Place> before = places, after = places;
        std::vector<Vector> tangents;
        for (size_t i = 0; i < places.size(); ++i) {
            tangents.push_back(unit(cross(places[i].normal, along)));
            before[i].position = places[i].position - tangents[i] * step;
            after[i].position = places[i].position + tangents[i] * step;
        }
        const auto low = values_on({nodes, "n.value"}, before, 1e-4);
        const auto high = values_on({nodes, "n.value"}, after, 1e-4);
        for (size_t i = 0; i < places.size(); ++i)
            EXPECT_NEAR(dot(vector_of(slopes[i]), tangents[i]),
                        (high[i][0] - low[i][0]) / (2 * step), 1e-5);
    }
}

// clang-format off
const Range sloped[] = {
    {"gradient_noise", R"("octaves": 1)"}, {"gradient_noise", ""},
    {"simplex_noise", ""}, {"value_noise", ""},
    {"fbm", R"("basis": "simplex")"}, {"fbm", R"("basis": "value")"},
    {"turbulence", ""}, {"turbulence", R"("basis": "simplex")"},
    {"ridged", ""}, {"ridged", R"("basis": "value")"}, {"dents", R"("threshold": 0.1)"},
    {"fbm", R"("seed": 3)"}, {"simplex_noise", R"("seed": 3)"},
};
// clang-format on
INSTANTIATE_TEST_SUITE_P(Noises, NoiseSlope, ::testing::ValuesIn(sloped));

TEST(ValueNoise, IsTheHashAtLatticePoints) {
    const auto noise = value_of("value_noise", "", {{0, 0}, {3, -8}, {-200, 41}});
    const int cells[][2] = {{0, 0}, {3, -8}, {-200, 41}};
    for (size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(noise[i], 2 * unit_number(pcg(cells[i][0], cells[i][1], 0)) - 1, 1e-6);
}

// Distances to all points in the cells within three of the position, sorted.
std::vector<double> distances(double x, double y, double z, double jitter) {
    std::vector<double> all;
    const int cx = static_cast<int>(std::floor(x)), cy = static_cast<int>(std::floor(y)),
              cz = static_cast<int>(std::floor(z));
    for (int i = cx - 3; i <= cx + 3; ++i)
        for (int j = cy - 3; j <= cy + 3; ++j)
            for (int k = cz - 3; k <= cz + 3; ++k) {
                const uint32_t first = pcg(i, j, k), second = pcg(first), third = pcg(second);
                const double dx = i + 0.5 + jitter * (unit_number(first) - 0.5) - x,
                             dy = j + 0.5 + jitter * (unit_number(second) - 0.5) - y,
                             dz = k + 0.5 + jitter * (unit_number(third) - 0.5) - z;
                all.push_back(std::sqrt(dx * dx + dy * dy + dz * dz));
            }
    std::sort(all.begin(), all.end());
    return all;
}

// Evaluated at height z above the plane, with one cell per length unit.
std::vector<double> worley(double z, const std::string& in, const std::vector<Point>& places) {
    const std::string nodes =
        R"("up": {"type": "vec3_add", "in": {"a": {"from": "surface.position"}, "b": [0, 0, )" +
        std::to_string(z) + "]}}, " +
        one("worley_noise", R"("point": {"from": "up.vector"}, "scale": 1, )" + in);
    std::vector<double> numbers;
    for (const auto& lanes : values({nodes, "n.value"}, places))
        numbers.push_back(lanes[0]);
    return numbers;
}

TEST(WorleyNoise, IsTheDistanceToItsPoints) {
    const auto places = random_cells(3000, 60, 3);
    const std::pair<double, double> cases[] = {{0, 0.6}, {0.37, 0}, {-4.8, 1}, {0.95, 1}};
    for (const auto& [z, jitter] : cases) {
        const std::string in = "\"jitter\": " + std::to_string(jitter) + ", \"distance\": ";
        const auto f1 = worley(z, in + "\"f1\"", places), f2 = worley(z, in + "\"f2\"", places),
                   difference = worley(z, in + "\"f2_minus_f1\"", places);
        int other = 0;
        for (size_t i = 0; i < places.size(); ++i) {
            const auto truth = distances(places[i][0], places[i][1], z, jitter);
            EXPECT_NEAR(f1[i], truth[0], 1e-5);
            other += std::fabs(f2[i] - truth[1]) > 1e-5 ? 1 : 0;
            EXPECT_NEAR(difference[i], f2[i] - f1[i], 1e-9);
        }
        EXPECT_LE(other, 3) << "second distances, jitter " << jitter;
    }
}

// The noise of one octave: gradient noise, with the point moved and scaled by the graph as
// documented for the octaves of a fractal.
std::vector<double> octave(int k, const std::string& basis, const std::vector<Point>& places) {
    std::string nodes, point = "surface.position";
    if (k > 0) {
        const double scale = std::pow(2.5, k);
        nodes = R"("s": {"type": "vec3_scale", "in": {"vector": {"from": "surface.position"}, )"
                R"("factor": )" +
                std::to_string(scale) +
                R"(}}, "p": {"type": "vec3_add", "in": {"a": {"from": "s.vector"}, "b": [)" +
                std::to_string(19.19 * k) + ", " + std::to_string(7.43 * k) + ", " +
                std::to_string(31.71 * k) + "]}}, ";
        point = "p.vector";
    }
    const std::string single = basis == "gradient" ? R"(, "octaves": 1)" : "";
    nodes += one(basis + "_noise", R"("point": {"from": ")" + point + R"("}, "scale": 1)" + single);
    std::vector<double> numbers;
    for (const auto& lanes : values({nodes, "n.value"}, places))
        numbers.push_back(lanes[0]);
    return numbers;
}

class Fractals : public ::testing::TestWithParam<const char*> {};

TEST_P(Fractals, AreMadeOfTheirOctaves) {
    const std::string basis = GetParam();
    const auto places = random_cells(300, 9, 8);
    const std::vector<double> n[] = {octave(0, basis, places), octave(1, basis, places),
                                     octave(2, basis, places)};
    const auto fractal = [&](const char* type) {
        std::vector<double> numbers;
        const std::string in = R"("scale": 1, "octaves": 3, "lacunarity": 2.5, "gain": 0.4)";
        for (const auto& lanes :
             values({one(type, in + R"(, "basis": ")" + basis + "\""), "n.value"}, places))
            numbers.push_back(lanes[0]);
        return numbers;
    };
    const auto fbm = fractal("fbm"), turbulence = fractal("turbulence"), ridged = fractal("ridged");
    for (size_t i = 0; i < places.size(); ++i) {
        double sum = 0, folded = 0, ridges = 0, below = 1;
        for (int k = 0; k < 3; ++k) {
            const double weight = std::pow(0.4, k);
            sum += weight * n[k][i];
            folded += weight * std::fabs(n[k][i]);
            const double ridge = std::pow(1 - std::fabs(n[k][i]), 2) * below;
            ridges += weight * ridge;
            below = std::min(2 * ridge, 1.0);
        }
        EXPECT_NEAR(fbm[i], sum / 1.56, 1e-6);
        EXPECT_NEAR(turbulence[i], folded / 1.56, 1e-6);
        EXPECT_NEAR(ridged[i], ridges / 1.56, 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(Bases, Fractals, ::testing::Values("gradient", "simplex", "value"));

// The documented offset of a seed, in cells.
std::array<double, 3> offset_of(int seed) {
    std::array<double, 3> offset{};
    for (uint32_t axis = 0; axis < 3; ++axis)
        offset[axis] =
            std::floor(unit_number(pcg(static_cast<uint32_t>(seed) + pcg(axis))) * 65536) - 32768;
    return offset;
}

// A node "p": the position times a factor, moved.
std::string moved_point(double factor, const std::array<double, 3>& by) {
    std::string vector;
    for (const double each : by)
        vector += (vector.empty() ? "" : ", ") + std::to_string(each);
    return R"("s": {"type": "vec3_scale", "in": {"vector": {"from": "surface.position"},)"
           R"("factor": )" +
           std::to_string(factor) +
           R"(}}, "p": {"type": "vec3_add", "in": {"a": {"from": "s.vector"}, "b": [)" + vector +
           "]}}, ";
}

// Another seed reads the same noise at the position moved by that many cells. Those of simplex
// noise are cells of the skewed lattice.
TEST(Seeds, MoveANoiseByCells) {
    const std::vector<Point> places = random_cells(200, 9, 12);
    struct Noise {
        std::string type, in;
    };
    const Noise noises[] = {{"gradient_noise", R"(, "octaves": 1)"},
                            {"simplex_noise", ""},
                            {"value_noise", ""},
                            {"worley_noise", ""},
                            {"fbm", R"(, "octaves": 1)"},
                            {"turbulence", R"(, "octaves": 1)"},
                            {"ridged", R"(, "octaves": 1)"},
                            {"dents", R"(, "octaves": 1, "threshold": 0)"}};
    for (const Noise& noise : noises) {
        const std::string& type = noise.type;
        std::array<double, 3> offset = offset_of(7);
        const double skew = type == "simplex_noise" ? (offset[0] + offset[1] + offset[2]) / 6 : 0;
        for (double& each : offset)
            each -= skew;
        const auto read_noise = [&](const std::string& nodes, const std::string& more) {
            return values({nodes + one(type, R"("scale": 1)" + more + noise.in), "n.value"},
                          places);
        };
        const auto other = read_noise("", R"(, "seed": 7)"), unmoved = read_noise("", "");
        const auto moved = read_noise(moved_point(1, offset), R"(, "point": {"from": "p.vector"})");
        double apart = 0;
        for (size_t i = 0; i < places.size(); ++i) {
            // The moved point is written with six decimals.
            EXPECT_NEAR(other[i][0], moved[i][0], 1e-5) << type;
            apart = std::max(apart, std::fabs(other[i][0] - unmoved[i][0]));
        }
        EXPECT_GT(apart, 0.05) << type;
    }
}

// Octave 1 of a fractal is read at the doubled position, moved by (19.19, 7.43, 31.71) and by the
// same cells.
TEST(Seeds, MoveEachOctaveByTheSameCells) {
    const auto places = random_cells(200, 9, 13);
    const std::array<double, 3> offset = offset_of(65535);
    const auto octave = [&](double k) {
        const std::string nodes =
            moved_point(1 + k,
                        {offset[0] + k * 19.19, offset[1] + k * 7.43, offset[2] + k * 31.71}) +
            one("value_noise", R"("point": {"from": "p.vector"}, "scale": 1)");
        return values({nodes, "n.value"}, places);
    };
    const auto first = octave(0), second = octave(1);
    const std::string fbm = R"("scale": 1, "basis": "value", "octaves": 2, "seed": 65535)";
    const auto sum = values({one("fbm", fbm), "n.value"}, places);
    for (size_t i = 0; i < places.size(); ++i)
        EXPECT_NEAR(sum[i][0], (first[i][0] + 0.5 * second[i][0]) / 1.5, 2e-6);
}

// Scratches of another seed are other ones of the same density, and so are waves.
TEST(Seeds, GiveOtherScratchesAndWaves) {
    const auto places = random_cells(4000, 60, 14);
    for (const char* type : {"scratches", "waves"}) {
        const auto first = value_of(type, "", places),
                   other = value_of(type, "\"seed\": 3", places);
        double sum = 0, of_other = 0, apart = 0;
        for (size_t i = 0; i < places.size(); ++i) {
            sum += first[i] / 4000, of_other += other[i] / 4000;
            apart += std::fabs(first[i] - other[i]) / 4000;
        }
        EXPECT_NEAR(sum, of_other, 0.02) << type;
        EXPECT_GT(apart, 0.05) << type;
    }
}

TEST(Dents, AreAPowerOfTurbulence) {
    const auto places = random_cells(500, 40, 5);
    const auto turbulence = value_of("turbulence", "", places);
    const auto dents = value_of("dents", R"("threshold": 0.25, "power": 2.5)", places);
    int deep = 0;
    for (size_t i = 0; i < places.size(); ++i) {
        const double over = std::max((turbulence[i] - 0.25) / 0.75, 0.0);
        EXPECT_NEAR(dents[i], -std::pow(over, 2.5), 1e-6);
        deep += over > 0 ? 1 : 0;
    }
    EXPECT_GT(deep, 50);
    EXPECT_LT(deep, 450);
}

}  // namespace
}  // namespace wrinkle::test

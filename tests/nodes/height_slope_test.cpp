// Tests of the slope of a height texture, close up: kernel weights, fade, borders, and the error of
// each filter method against the painted height.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

// Heights without a symmetry that could hide an error.
double rough(int column, int row) {
    const uint32_t bits = (static_cast<uint32_t>(column) * 7919u + 104729u) ^
                          (static_cast<uint32_t>(row) * 2654435761u);
    return (bits * 2246822519u >> 8) / 16777216.0;
}

constexpr int size = 16;

Image rough_image() {
    Image image = make_image(size, size, 1);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
            image.texel(static_cast<uint32_t>(column), static_cast<uint32_t>(row))[0] =
                static_cast<float>(rough(column, row));
    return image;
}

// "amplitude" 1 and "midlevel" 0, so that heights are the texels'.
std::string map(const std::string& in) {
    const std::string wrap = R"({"file": "textures/bricks_height.png", "wrap": "clamp"})";
    return R"("n": {"type": "height_map", "in": {"amplitude": 1, "midlevel": 0, )" + in +
           R"(, "image": )" + wrap + "}}";
}

struct Weights {
    double t, across[4], along[4];
};
// From the reference's test matrix, T10.
constexpr Weights published[] = {
    {0.0, {0.25, 0.5, 0.25, 0}, {-0.5, 0, 0.5, 0}},
    {0.5, {0.125, 0.375, 0.375, 0.125}, {-0.25, -0.25, 0.25, 0.25}},
    {1.0, {0, 0.25, 0.5, 0.25}, {0, -0.5, 0, 0.5}},
};

int inside(int i) {
    return i < 0 ? 0 : i >= size ? size - 1 : i;
}

// dh/d(u,v) at offset (`u`, `v`) from the centre of a texel, by the 16 texels around.
std::array<double, 2> by_kernel(int column, int row, const Weights& u, const Weights& v) {
    std::array<double, 2> slope{};
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const double h = rough(inside(column + i - 1), inside(row + j - 1));
            slope[0] += size * u.along[i] * v.across[j] * h;
            slope[1] += size * u.across[i] * v.along[j] * h;
        }
    return slope;
}

TEST(HeightSlope, IsThePublishedKernelCloseUpAlsoAtTheBorder) {
    const Image image = rough_image();
    const std::string smooth = map(R"("quality": "smooth")");
    for (const int column : {0, 1, 7, size - 2})
        for (const int row : {0, 5, size - 2})
            for (const Weights& u : published)
                for (const Weights& v : published) {
                    const auto slope = by_kernel(column, row, u, v);
                    const auto got = value({smooth, "n.gradient", image},
                                           (column + 0.5 + u.t) / size, (row + 0.5 + v.t) / size);
                    EXPECT_NEAR(got[0], slope[0], 1e-4) << column << " " << row << " " << u.t;
                    EXPECT_NEAR(got[1], slope[1], 1e-4) << column << " " << row << " " << v.t;
                }
}

TEST(HeightSlope, OfTwoScalesIsTheSameWhereUvIsALength) {
    const Image image = rough_image();
    for (const char* quality : {"smooth", "three_taps", "pixel"}) {
        const std::string in = R"("quality": ")" + std::string(quality) + R"(", "scale": )";
        const auto surface = value({map(in + R"("surface")"), "n.gradient", image}, 0.37, 0.71);
        const auto unit = value({map(in + R"("unit")"), "n.gradient", image}, 0.37, 0.71);
        for (size_t lane = 0; lane < 3; ++lane)
            EXPECT_NEAR(surface[lane], unit[lane], 1e-9) << quality;
    }
}

// dh/d(u,v) at one point of the texture, read with pixels that cover 2^lod texels.
std::array<double, 2> seen_at(const char* quality, double lod) {
    const double tiles = 1024.0 / size * std::exp2(lod);
    const std::string scale = std::to_string(tiles);
    const std::string tile =
        R"("t": {"type": "uv_transform", "in": {"scale": [)" + scale + ", " + scale + "]}}, ";
    const std::string in = R"("uv": {"from": "t.uv"}, "quality": ")" + std::string(quality) + "\"";
    const auto got =
        value({tile + map(in), "n.gradient", rough_image()}, 0.33 / tiles, 0.61 / tiles);
    return {got[0] / tiles, got[1] / tiles};
}

TEST(HeightSlope, FadesToThreeTapsFromLod0_05To0_5) {
    const auto close_up = seen_at("smooth", -1);
    const std::pair<double, double> share_of_smooth[] = {{0.02, 1}, {0.05, 1}, {0.275, 0.5},
                                                         {0.5, 0},  {0.6, 0},  {1.5, 0}};
    for (const auto& [lod, share] : share_of_smooth) {
        const auto taps = seen_at("three_taps", lod), mixed = seen_at("smooth", lod);
        for (size_t i = 0; i < 2; ++i)
            EXPECT_NEAR(mixed[i], taps[i] + (close_up[i] - taps[i]) * share, 2e-4) << lod;
    }
}

double hill(double x) {
    return 0.1 * std::sin(3 * x + 0.4);
}

constexpr double degrees = 57.29577951308232;

struct Crossed {
    double error = 0;  // root mean square angle to the painted slope, in degrees
    double jump = 0;   // the largest change of the slope between adjacent pixels
};

Crossed across_the_hill(const std::string& nodes, const Image& image) {
    std::vector<std::array<double, 2>> line;
    for (int i = 200; i < 800; ++i)
        line.push_back({i / 1024.0, 0.5});
    const auto got = values({nodes, "n.gradient", image}, line);
    Crossed seen;
    for (size_t i = 0; i < got.size(); ++i) {
        const double slope = 0.3 * std::cos(3 * line[i][0] + 0.4);
        seen.error += std::pow(std::atan(got[i][0]) - std::atan(slope), 2);
        if (i > 0) seen.jump = std::max(seen.jump, std::fabs(got[i][0] - got[i - 1][0]));
    }
    seen.error = std::sqrt(seen.error / static_cast<double>(got.size())) * degrees;
    return seen;
}

// Reference T10. One tap is discontinuous between texels; three taps are continuous, but offset by
// half a texel; a map of slopes in 8 bits is limited by its quantisation; the kernel is best.
TEST(HeightSlope, Pitfall10HasNoFacetsCloseUp) {
    const Image heights = painted(size, [](double u, double) {
        return std::array{hill(u), 0.0, 0.0};
    });
    const Image slopes = painted(size, [](double u, double) {
        const double texel = 1.0 / size;
        const double slope = (hill(u + texel) - hill(u - texel)) / (2 * texel);
        return std::array{std::round((slope * 0.5 + 0.5) * 255) / 255, 0.5, 0.0};
    });
    const Crossed one_tap = across_the_hill(map(R"("quality": "pixel")"), heights);
    const Crossed taps = across_the_hill(map(R"("quality": "three_taps")"), heights);
    const Crossed smooth = across_the_hill(map(R"("quality": "smooth")"), heights);
    const Crossed derivative = across_the_hill(one("derivative_map"), slopes);
    EXPECT_GT(one_tap.jump, 20 * taps.jump);
    EXPECT_GT(one_tap.jump, 20 * smooth.jump);
    EXPECT_GT(taps.error, derivative.error);
    EXPECT_GT(derivative.error, smooth.error);
    EXPECT_LT(smooth.error, 0.2);
}

}  // namespace
}  // namespace wrinkle::test

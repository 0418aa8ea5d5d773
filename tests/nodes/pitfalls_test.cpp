// Tests of common pitfalls of bump mapping, continued: storing, blending and scaling of maps. See
// docs/pitfalls.md.
#include <gtest/gtest.h>

#include <cmath>

#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

using Lanes = std::vector<double>;
using Color = std::array<double, 3>;

Image plain(Color color) {
    Image image = make_image(4, 4, 3);
    for (size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = static_cast<float>(color[i % 3]);
    return image;
}

// A map node with its image in this encoding, resolved as "r.normal".
std::string map(const std::string& type, const std::string& encoding, const std::string& in = "") {
    return R"("n": {"type": ")" + type +
           R"(", "in": {"image": {"file": "textures/weave_normal.png", "encoding": ")" + encoding +
           "\"}" + (in.empty() ? "" : ", " + in) +
           R"(}}, "r": {"type": "resolve", "in": {"gradient": {"from": "n.gradient"}}})";
}

void expect_near(const Lanes& got, const Lanes& expected, double tolerance) {
    ASSERT_EQ(got.size(), expected.size());
    for (size_t i = 0; i < got.size(); ++i)
        EXPECT_NEAR(got[i], expected[i], tolerance) << "lane " << i;
}

double tilt_deg(const Lanes& normal) {
    return std::atan2(std::hypot(normal[0], normal[1]), normal[2]) * 57.29577951308232;
}

// With denser tiling a `unit` bump keeps its slope, and a `surface` height becomes as steep as
// denser waves; there is no third behaviour.
TEST(Pitfalls, Pitfall11StrengthAndTilingAreTwoNamedThings) {
    const Image slopes = plain({0.75, 0.5, 0});
    const auto gradient = [&](const std::string& scale, double tiles) {
        const std::string tiling = std::to_string(tiles);
        return value({R"("t": {"type": "uv_transform", "in": {"scale": [)" + tiling + ", " +
                          tiling + "]}}, " +
                          map("derivative_map", "derivative",
                              R"("uv": {"from": "t.uv"}, "scale": ")" + scale + "\""),
                      "n.gradient", slopes});
    };
    for (const double tiles : {1.0, 4.0, 0.25}) {
        expect_near(gradient("unit", tiles), {0.5, 0, 0}, 1e-6);
        expect_near(gradient("surface", tiles), {0.5 * tiles, 0, 0}, 1e-6);
    }
}

Image gentle_ramp(double steps) {
    Image image = make_image(256, 4, 3);
    for (uint32_t y = 0; y < 4; ++y)
        for (uint32_t x = 0; x < 256; ++x)
            for (uint32_t c = 0; c < 3; ++c)
                image.texel(x, y)[c] =
                    static_cast<float>(std::round(0.1 * (x + 0.5) / 256 * steps) / steps);
    return image;
}

// A slope of a tenth over the image: 16 bits resolve it, 8 bits give 26 terraces.
TEST(Pitfalls, Pitfall15SixteenBitHeightsHaveNoTerraces) {
    std::vector<std::array<double, 2>> points;
    for (int i = 20; i < 230; ++i)
        points.push_back({(i + 0.3) / 256, 0.5});
    const auto worst = [&](double steps) {
        double most = 0;
        const std::string height = map("height_map", "linear", R"("amplitude": 5, "midlevel": 0)");
        for (const Lanes& g : values({height, "n.gradient", gentle_ramp(steps)}, points))
            most = std::fmax(most, std::abs(g[0] - 0.5));
        return most;
    };
    EXPECT_LE(worst(65535), 0.02);
    EXPECT_GT(worst(255), 0.2);
}

TEST(Pitfalls, Pitfall16GreenUpAndGreenDown) {
    const Image up = plain({0.2, 0.6, 0.9}), down = plain({0.2, 0.4, 0.9});
    const Lanes gl = value({map("tangent_normal_map", "normal_gl"), "r.normal", up});
    expect_near(value({map("tangent_normal_map", "normal_dx"), "r.normal", down}), gl, 1e-6);
    EXPECT_GT(gl[1], 0.1) << "green above a half leans towards +v";
    const Lanes wrong = value({map("tangent_normal_map", "normal_dx"), "r.normal", up});
    EXPECT_NEAR(wrong[1], -gl[1], 1e-6);
}

// Two channels, with the depth computed from them; files with a wrong vector length stay finite.
TEST(Pitfalls, Pitfall17TwoChannelMapsAndTheirDepth) {
    const double x = 0.36, y = -0.48, z = 0.8;
    const auto byte = [](double v) { return 0.5 + 0.5 * v; };
    const Lanes expected{x, y, z};
    const Image full = plain({byte(x), byte(y), byte(z)}), two = plain({byte(x), byte(y), 0});
    expect_near(value({map("tangent_normal_map", "normal_gl"), "r.normal", full}), expected, 1e-6);
    expect_near(value({map("tangent_normal_map", "normal_rg"), "r.normal", two}), expected, 1e-6);
    const Lanes too_long =
        value({map("tangent_normal_map", "normal_rg"), "r.normal", plain({1, 0, 0})});
    EXPECT_NEAR(tilt_deg(too_long), std::atan(128 * std::sqrt(2)) * 57.29577951308232, 1e-3);
    const Lanes blue_low = value(
        {map("tangent_normal_map", "normal_gl"), "r.normal", plain({byte(x), byte(y), byte(-z)})});
    expect_near(blue_low, expected, 1e-6);  // z is mirrored up
}

// 128 of 255 is not zero: its tilt is reproduced as stored; files with an exact half have none.
TEST(Pitfalls, Pitfall18TheMiddleOfEightBits) {
    const double middle = 128 / 255.0;
    const std::string node = map("tangent_normal_map", "normal_gl");
    EXPECT_NEAR(tilt_deg(value({node, "r.normal", plain({middle, middle, 1})})), 0.31776, 1e-4);
    EXPECT_LE(tilt_deg(value({node, "r.normal", plain({0.5, 0.5, 1})})), 1e-9);
}

// Twice the strength is twice the slope, for every kind of map; xy is never doubled and normalised.
TEST(Pitfalls, Pitfall19StrengthScalesSlopes) {
    const Image normals = plain({0.8, 0.4, 0.85});
    using Map = std::pair<const char*, const char*>;
    for (const Map& each : {Map{"tangent_normal_map", "normal_gl"},
                            {"object_normal_map", "normal_gl"},
                            {"derivative_map", "derivative"}}) {
        const auto slope = [&](double strength) {
            const std::string in = R"("strength": )" + std::to_string(strength);
            const Lanes n = value({map(each.first, each.second, in), "r.normal", normals});
            return Lanes{n[0] / n[2], n[1] / n[2]};
        };
        const Lanes once = slope(1);
        for (const double strength : {0.0, 0.5, 2.0, -1.0})
            expect_near(slope(strength), {once[0] * strength, once[1] * strength}, 1e-5);
    }
}

const std::string base_and_detail = map("tangent_normal_map", "normal_gl") +
                                    R"(, "flat": {"type": "gradient_from_volume"},
        "bump": {"type": "gradient_from_volume", "in": {"volume": [0.3, -0.2, 0]}}, )";

std::string layered(const std::string& type, const std::string& a, const std::string& b,
                    const std::string& more = "") {
    return base_and_detail + R"("l": {"type": ")" + type + R"(", "in": {"a": {"from": ")" + a +
           R"("}, "b": {"from": ")" + b + "\"}" + more + "}}";
}

// A flat detail, or one at half strength, leaves the strength of the base unchanged.
TEST(Pitfalls, Pitfall20DetailDoesNotFlattenTheBase) {
    const Image normals = plain({0.8, 0.4, 0.85});
    const Lanes base = value({map("tangent_normal_map", "normal_gl"), "n.gradient", normals});
    const auto sum = [&](const std::string& nodes) {
        return value({nodes, "l.gradient", normals});
    };
    expect_near(sum(layered("gradient_add", "n.gradient", "flat.gradient")), base, 1e-9);
    const Lanes half = sum(
        base_and_detail +
        R"("h": {"type": "gradient_scale", "in": {"gradient": {"from": "bump.gradient"}, "amount": 0.5}},
           "l": {"type": "gradient_add", "in": {"a": {"from": "n.gradient"}, "b": {"from": "h.gradient"}}})");
    expect_near(half, {base[0] + 0.15, base[1] - 0.1, 0}, 1e-6);
}

// A normal map and a grey height are added directly; a second normal map is not needed.
TEST(Pitfalls, Pitfall22ANormalMapAndAHeightAddUp) {
    const Image ramp = painted(64, [](double u, double v) {
        return std::array{0.5 + 0.25 * u, 0.5 + 0.25 * v, 1.0};
    });
    const std::string both =
        map("tangent_normal_map", "normal_gl") +
        R"(, "h": {"type": "height_map", "in": {"image": "textures/weave_height.png", "amplitude": 2}},
            "l": {"type": "gradient_add", "in": {"a": {"from": "n.gradient"}, "b": {"from": "h.gradient"}}})";
    // m = (0.5 u, 0.5 v, 1) at (0.3, 0.6), and a height of 2 (0.5 + 0.25 u).
    expect_near(value({both, "l.gradient", ramp}), {-0.15 + 0.5, -0.3, 0}, 3e-3);
}

// The port decides if an image is a height or a normal; its pixels are not inspected: three equal
// grey channels are a height at a height port.
TEST(Pitfalls, Pitfall29AGreyPictureIsNotTakenForNormals) {
    const Image grey = painted(64, [](double u, double) {
        return std::array{0.25 * u, 0.25 * u, 0.25 * u};
    });
    const std::string height =
        R"("n": {"type": "height_map", "in": {"image": "textures/weave_height.png", "amplitude": 2}})";
    expect_near(value({height, "n.gradient", grey}), {0.5, 0, 0}, 3e-3);
}

}  // namespace
}  // namespace wrinkle::test

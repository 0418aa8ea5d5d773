// Tests of decals: their position, and how their bumps combine with others; and of cube maps of
// normals, by the tables of the OpenGL specification.
#include <gtest/gtest.h>

#include <cmath>

#include "nodes/solid.h"

namespace wrinkle::test {
namespace {

double arrives(const std::string& type, const std::string& in, Place place) {
    return value_on({one(type, in), "n.attenuation"}, place)[0];
}

TEST(Decals, ABoxEndsAtItsSides) {
    const std::string in = R"("origin": [0, 0, 0], "size": [2, 4, 6], "edge": 0.5)";
    const auto at = [&](Vector p) { return arrives("decal_box", in, {p, {0, 0, 1}}); };
    EXPECT_EQ(at({0, 0, 0}), 1);
    EXPECT_EQ(at({0.49, 0.99, -1.49}), 1);
    for (const Vector outside : {Vector{1, 0, 0}, Vector{0, -2, 0}, Vector{0, 0, 3}})
        EXPECT_EQ(at(outside), 0);
    EXPECT_NEAR(at({0.75, 0, 0}), 0.5, 1e-9);
    EXPECT_NEAR(at({0, 1.5, 2.25}), 0.25, 1e-9);
}

TEST(Decals, AConeEndsAtItsAngleAndRange) {
    const std::string in =
        R"("origin": [0, 0, 0], "direction": [0, 0, 1], "angle": 90, "range": 4, "edge": 0.5,
           "angle_fade": 0)";
    const auto at = [&](Vector p) { return arrives("decal_cone", in, {p, {0, 0, -1}}); };
    EXPECT_EQ(at({0, 0, 1}), 1);
    EXPECT_EQ(at({0.49, 0, 1}), 1);
    EXPECT_NEAR(at({0, 0.75, 1}), 0.5, 1e-9);
    EXPECT_EQ(at({1.01, 0, 1}), 0);
    EXPECT_NEAR(at({0, 0, 3}), 0.5, 1e-9);
    EXPECT_EQ(at({0, 0, 4.01}), 0);
    EXPECT_EQ(at({0, 0, -1}), 0);  // behind
    EXPECT_EQ(at({0, 0, 0}), 0);
}

TEST(Decals, BallsAndCapsulesReachEquallyFarFromTheirLine) {
    const std::string ball = R"("origin": [1, 0, 0], "radius": 2, "edge": 0.5)";
    EXPECT_NEAR(arrives("decal_sphere", ball, {{1, 1.5, 0}, {0, 0, 1}}), 0.5, 1e-9);
    EXPECT_EQ(arrives("decal_sphere", ball, {{1, 0, 2.01}, {0, 0, 1}}), 0);
    const std::string capsule =
        R"("start": [-1, 0, 0], "end": [3, 0, 0], "radius": 2, "edge": 0.5)";
    for (const Vector p :
         {Vector{0, 1.5, 0}, Vector{2, 0, -1.5}, Vector{-2.5, 0, 0}, Vector{3, 0, 1.5}})
        EXPECT_NEAR(arrives("decal_capsule", capsule, {p, {0, 0, 1}}), 0.5, 1e-9);
    const auto out =
        value_on({one("decal_capsule", capsule), "n.direction"}, {{-2, 0, 1}, {0, 0, 1}});
    EXPECT_NEAR(angle_deg(vector_of(out), {-1, 0, 1}), 0, 1e-6);
}

TEST(Decals, FadeWhereTheSurfaceTurnsAway) {
    for (const double cosine : {1.0, 0.5, 0.1}) {
        const Vector n{std::sqrt(1 - cosine * cosine), 0, cosine};
        EXPECT_NEAR(arrives("decal_box", R"("origin": [0, 0, 0])", {{0, 0, 0}, n}),
                    std::pow(cosine, 0.2), 1e-9);
    }
    EXPECT_EQ(arrives("decal_box", R"("origin": [0, 0, 0])", {{0, 0, 0}, {0, 0.6, -0.8}}), 0);
}

TEST(Decals, AddOrReplaceBumps) {
    const std::string bumps =
        R"("a": {"type": "gradient_from_volume", "in": {"volume": [0.2, -0.4, 7]}},
           "b": {"type": "gradient_from_volume", "in": {"volume": [1, 2, 3]}}, )";
    const std::string in = R"("gradient": {"from": "a.gradient"}, "decal": {"from": "b.gradient"},
        "attenuation": 0.25, "strength": 2)";
    const auto added = value({bumps + one("decal_add", in), "n.gradient"});
    EXPECT_NEAR(added[0], 0.2 + 0.5, 1e-9);
    EXPECT_NEAR(added[1], -0.4 + 1, 1e-9);
    const auto masked = value({bumps + one("decal_mask", in), "n.gradient"});
    EXPECT_NEAR(masked[0], 0.75 * 0.2 + 0.5, 1e-9);
    EXPECT_NEAR(masked[1], 0.75 * -0.4 + 1, 1e-9);
}

// OpenGL 4.6, table 8.19: the face of a direction, and s and t within it, t downwards.
struct Looked {
    int face;
    double s, t;
};
Vector direction_of(Looked at) {
    const double sc = 2 * at.s - 1, tc = 2 * at.t - 1;
    switch (at.face) {
        case 0:
            return {1, -tc, -sc};
        case 1:
            return {-1, -tc, sc};
        case 2:
            return {sc, 1, tc};
        case 3:
            return {sc, -1, -tc};
        case 4:
            return {sc, -tc, 1};
        default:
            return {-sc, -tc, -1};
    }
}

constexpr uint32_t face_size = 128;
Image cube_picture(bool strip, const std::function<Vector(Looked)>& color) {
    const uint32_t columns = strip ? 6 : 3, rows = strip ? 1 : 2;
    Image image = make_image(columns * face_size, rows * face_size, 3);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            // Image rows go upwards here, as v does.
            const uint32_t row = rows - 1 - y / face_size;
            const Looked at{static_cast<int>(x / face_size + columns * row),
                            (x % face_size + 0.5) / face_size,
                            1 - (y % face_size + 0.5) / face_size};
            const Vector c = color(at);
            float* texel = &image.texel(x, y)[0];
            texel[0] = static_cast<float>(c.x);
            texel[1] = static_cast<float>(c.y);
            texel[2] = static_cast<float>(c.z);
        }
    return image;
}

double ball_relief(Vector p) {
    return 0.02 * std::sin(5 * p.x + 3 * p.y) + 0.01 * std::cos(7 * p.z - 2 * p.x);
}
Vector encoded_normal(Looked at) {
    const Vector n = displaced_on_sphere(unit(direction_of(at)), ball_relief);
    return n * 0.5 + Vector{0.5, 0.5, 0.5};
}

TEST(CubeNormalMap, LeadsToTheNormalsOfADisplacedSphere) {
    for (const bool strip : {true, false}) {
        const Image picture = cube_picture(strip, encoded_normal);
        const std::string in = strip ? "" : R"("arrangement": "grid")";
        const Scene scene{one("cube_normal_map", in), "n.gradient", picture};
        const Scene volume{one("cube_normal_map", in), "n.volume", picture};
        const auto places = on_sphere(500);
        const auto gradients = values_on(scene, places), volumes = values_on(volume, places);
        double most = 0;
        for (size_t i = 0; i < gradients.size(); ++i) {
            const Vector n = places[i].normal, truth = displaced_on_sphere(n, ball_relief);
            EXPECT_LT(angle_deg(unit(n - vector_of(gradients[i])), truth), 0.5);
            EXPECT_LT(angle_deg(unit(n - vector_of(volumes[i])), truth), 0.5);
            most = std::fmax(most, angle_deg(n, truth));
        }
        EXPECT_GT(most, 5);
    }
}

// Each face has one color: no footprint may blend in a neighbouring face of the image.
TEST(CubeNormalMap, ReadsNoTexelOfANeighbourInThePicture) {
    for (const bool strip : {true, false}) {
        const Image picture = cube_picture(strip, [](Looked at) {
            return at.face % 2 ? Vector{0.5, 0.5, 1} : Vector{1, 0.5, 0.5};
        });
        const Scene scene{one("cube_normal_map", strip ? "" : R"("arrangement": "grid")"),
                          "n.gradient", picture};
        for (const double size : {1.0 / 1024, 1.0 / 32, 0.25, 2.0})
            for (int face = 0; face < 6; ++face)
                for (const double s : {0.001, 0.02, 0.5, 0.98, 0.999}) {
                    const Vector n = face % 2 ? Vector{0, 0, 1} : Vector{1, 0, 0};
                    const auto g = value_on(scene, {direction_of({face, s, 1 - s * s}), n}, size);
                    EXPECT_NEAR(std::sqrt(dot(vector_of(g), vector_of(g))), 0, 1e-5)
                        << "face " << face << ", s " << s << ", pixel " << size;
                }
    }
}

}  // namespace
}  // namespace wrinkle::test

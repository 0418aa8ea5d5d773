// Tests of tangent frames as values, and of normals that face the viewer.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

void expect_near(const std::vector<double>& got, std::array<double, 3> expected) {
    ASSERT_EQ(got.size(), 3u);
    for (size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(got[i], expected[i], 1e-6) << "lane " << i;
}

TEST(TangentFrame, RunsAlongTheUv) {
    for (const char* frame : {"auto", "vertex", "derived"}) {
        const std::string node =
            one("tangent_frame", R"("frame": ")" + std::string(frame) + R"(")");
        expect_near(value({node, "n.tangent"}), {1, 0, 0});
        expect_near(value({node, "n.bitangent"}), {0, 1, 0});
    }
    // A quarter turn anticlockwise of the uv: u points down, v to the right.
    const std::string turned =
        R"("t": {"type": "uv_transform", "in": {"rotation": 90}}, )" +
        one("tangent_frame", R"("uv": {"from": "t.uv"}, "frame": "derived")");
    expect_near(value({turned, "n.tangent"}), {0, -1, 0});
    expect_near(value({turned, "n.bitangent"}), {1, 0, 0});
}

TEST(TangentMap, GivesDirectionsAlongTheSurfaceOrInSpace) {
    // (0.6, -0.2, 0.5) before encoding
    const Image map = painted(8, [](double, double) { return std::array{0.8, 0.4, 0.75}; });
    expect_near(value({one("tangent_map"), "n.direction", map}), {0.6, -0.2, 0});
    const std::string object = one("tangent_map", R"("space": "object")");
    expect_near(value({object, "n.direction", map}), {0.6, -0.2, 0.5});
}

// S4: with the tangent from a rule, B = normalize(N x up) and T = B x N equal Gram-Schmidt.
TEST(GuessedFrame, IsTheCrossProductMethodToo) {
    const Image map = painted(8, [](double, double) { return std::array{0.2, 0.6, 0.75}; });
    const std::array<double, 3> up{0.3, 0.8, -0.5}, n{0, 0, 1};
    std::array<double, 3> b{n[1] * up[2] - n[2] * up[1], n[2] * up[0] - n[0] * up[2], 0};
    const double length = std::hypot(b[0], b[1]);
    for (double& x : b)
        x /= length;
    const std::array<double, 3> t{b[1] * n[2] - b[2] * n[1], b[2] * n[0] - b[0] * n[2], 0};
    // Slopes of (-0.6, 0.2, 0.5): 1.2 along T, -0.4 along B.
    const std::string node =
        one("tangent_normal_map", R"("frame": "guess", "direction": [0.3, 0.8, -0.5])");
    expect_near(value({node, "n.gradient", map}),
                {1.2 * t[0] - 0.4 * b[0], 1.2 * t[1] - 0.4 * b[1], 0});
}

TEST(DerivativeMap, FlipsEitherSlope) {
    const Image slopes = painted(8, [](double, double) { return std::array{0.75, 0.375, 0.0}; });
    const auto map = [](const char* in) { return one("derivative_map", in); };
    expect_near(value({map(R"("flip_u": true)"), "n.gradient", slopes}), {-0.5, -0.25, 0});
    expect_near(value({map(R"("flip_v": true)"), "n.gradient", slopes}), {0.5, 0.25, 0});
}

// Points with tangents that are neither unit nor orthogonal to a normal of any length, mirrored or
// not.
PointSet leaning_points(const Scene& scene, glm::dvec3 n, glm::dvec3 t, double w) {
    PointSet points = plane_points(scene, {{0.3, 0.6}, {-0.2, 0.9}});
    auto& normals = points.at(SurfaceInput::normal_, Variant::value);
    auto& tangents = points.at(SurfaceInput::tangent_, Variant::value);
    for (size_t i = 0; i < points.count; ++i) {
        for (int lane = 0; lane < 3; ++lane) {
            normals[3 * i + static_cast<size_t>(lane)] = n[lane];
            tangents[4 * i + static_cast<size_t>(lane)] = t[lane];
        }
        tangents[4 * i + 3] = w;
    }
    return points;
}

const std::string slanted =
    R"("g": {"type": "gradient_from_volume", "in": {"volume": [1.5, -2, 0.7]}},
    "r": {"type": "resolve", "in": {"gradient": {"from": "g.gradient"}}}, )";

// Eq. 24: conversion to tangent space and back is the identity, in every frame.
TEST(TangentSpaceNormal, DecodesToTheNormalThatItWasMadeFrom) {
    const std::string turned = R"("t": {"type": "uv_transform", "in": {"rotation": 25,
        "scale": [-3, 2]}}, )";
    for (const char* frame :
         {R"("frame": "vertex")", R"("frame": "derived")", R"("frame": "auto")",
          R"("scale": "surface")", R"("frame": "guess", "direction": [0.3, 0.8, -0.5])"})
        for (const char* uv : {"surface.uv0", "t.uv"}) {
            const std::string in = R"("uv": {"from": ")" + std::string(uv) + "\"}, " + frame;
            const std::string nodes =
                slanted + turned +
                one("tangent_space_normal", R"("normal": {"from": "r.normal"}, )" + in) +
                R"(, "d": {"type": "gradient_from_tangent_normal", "in": {"normal": {"from": "n.normal"}, )" +
                in +
                R"(}}, "back": {"type": "resolve", "in": {"gradient": {"from": "d.gradient"}}})";
            for (const double w : {1.0, -1.0}) {
                const auto there = Scene{nodes, "r.normal"}, back = Scene{nodes, "back.normal"};
                const glm::dvec3 n(0.2, -0.1, 0.7), t(0.6, 0.3, 0.1);
                const auto expected = values(there, leaning_points(there, n, t, w));
                const auto got = values(back, leaning_points(back, n, t, w));
                ASSERT_EQ(got.size(), expected.size());
                for (size_t i = 0; i < got.size(); ++i)
                    expect_near(got[i], {expected[i][0], expected[i][1], expected[i][2]});
            }
        }
}

// MikkTSpace's decode is normalize([T B N] m): solved for m by brute force.
TEST(TangentSpaceNormal, SolvesTheDecodeOfVertexTangents) {
    const std::string nodes = slanted + one("tangent_space_normal",
                                            R"("normal": {"from": "r.normal"}, "frame": "vertex")");
    for (const double w : {1.0, -1.0}) {
        const glm::dvec3 n(0.2, -0.1, 0.7), t(0.6, 0.3, 0.1);
        const Scene scene{nodes, "n.normal"}, resolved{nodes, "r.normal"};
        const auto normals = values(resolved, leaning_points(resolved, n, t, w));
        const auto got = values(scene, leaning_points(scene, n, t, w));
        for (size_t i = 0; i < got.size(); ++i) {
            const glm::dvec3 v(normals[i][0], normals[i][1], normals[i][2]);
            const glm::dvec3 m =
                glm::normalize(glm::inverse(glm::dmat3(t, w * glm::cross(n, t), n)) * v);
            EXPECT_LT(m.z, 0.9) << "not flat";
            expect_near(got[i], {m.x, m.y, m.z});
        }
    }
}

TEST(TangentSpaceNormal, IsFlatWhereThereIsNoFrame) {
    const std::string nodes =
        slanted + one("tangent_space_normal", R"("normal": {"from": "r.normal"}, "uv": [1, 2])");
    expect_near(value({nodes, "n.normal"}), {0, 0, 1});
    expect_near(value({nodes, "n.color"}), {0.5, 0.5, 1});
}

// Pitfall 27: a normal that points away from the viewer shades black.
TEST(FaceViewer, Pitfall27MirrorsNormalsThatLookAway) {
    const auto turned = [](const char* normal) {
        return value({one("face_viewer", R"("normal": )" + std::string(normal)), "n.normal"});
    };
    expect_near(turned("[0.6, 0, 0.8]"), {0.6, 0, 0.8});
    expect_near(turned("[0.6, 0, -0.8]"), {0.6, 0, 0.8});
    expect_near(turned("[1, 0, 0]"), {1, 0, 0});
}

}  // namespace
}  // namespace wrinkle::test

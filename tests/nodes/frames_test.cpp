// Tangent frames as values, and normals that face the viewer.
#include <gtest/gtest.h>

#include <cmath>

#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

void expect_vector(const std::vector<double>& got, std::array<double, 3> expected) {
    ASSERT_EQ(got.size(), 3u);
    for (size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(got[i], expected[i], 1e-6) << "lane " << i;
}

TEST(TangentFrame, RunsAlongTheUv) {
    for (const char* frame : {"auto", "vertex", "derived"}) {
        const std::string node =
            one("tangent_frame", R"("frame": ")" + std::string(frame) + R"(")");
        expect_vector(value({node, "n.tangent"}), {1, 0, 0});
        expect_vector(value({node, "n.bitangent"}), {0, 1, 0});
    }
    // A quarter turn anticlockwise of the uv: u runs down, v to the right.
    const std::string turned =
        R"("t": {"type": "uv_transform", "in": {"rotation": 90}}, )" +
        one("tangent_frame", R"("uv": {"from": "t.uv"}, "frame": "derived")");
    expect_vector(value({turned, "n.tangent"}), {0, -1, 0});
    expect_vector(value({turned, "n.bitangent"}), {1, 0, 0});
}

TEST(TangentMap, GivesDirectionsAlongTheSurfaceOrInSpace) {
    // (0.6, -0.2, 0.5) before encoding
    const Image map = painted(8, [](double, double) { return std::array{0.8, 0.4, 0.75}; });
    expect_vector(value({one("tangent_map"), "n.direction", map}), {0.6, -0.2, 0});
    const std::string object = one("tangent_map", R"("space": "object")");
    expect_vector(value({object, "n.direction", map}), {0.6, -0.2, 0.5});
}

// S4: with the tangent from a rule, B = N x up made unit and T = B x N are what Gram-Schmidt gives.
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
    expect_vector(value({node, "n.gradient", map}),
                  {1.2 * t[0] - 0.4 * b[0], 1.2 * t[1] - 0.4 * b[1], 0});
}

TEST(DerivativeMap, FlipsEitherSlope) {
    const Image slopes = painted(8, [](double, double) { return std::array{0.75, 0.375, 0.0}; });
    const auto map = [](const char* in) { return one("derivative_map", in); };
    expect_vector(value({map(R"("flip_u": true)"), "n.gradient", slopes}), {-0.5, -0.25, 0});
    expect_vector(value({map(R"("flip_v": true)"), "n.gradient", slopes}), {0.5, 0.25, 0});
}

// Pitfall 27: a normal that looks away shades black.
TEST(FaceViewer, Pitfall27MirrorsNormalsThatLookAway) {
    const auto turned = [](const char* normal) {
        return value({one("face_viewer", R"("normal": )" + std::string(normal)), "n.normal"});
    };
    expect_vector(turned("[0.6, 0, 0.8]"), {0.6, 0, 0.8});
    expect_vector(turned("[0.6, 0, -0.8]"), {0.6, 0, 0.8});
    expect_vector(turned("[1, 0, 0]"), {1, 0, 0});
}

}  // namespace
}  // namespace wrinkle::test

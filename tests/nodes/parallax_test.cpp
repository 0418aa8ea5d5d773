// Tests of relief with parallax against rays that are traced through the same relief in small
// steps: the oracle uses heights as C++ functions and no texture space.
#include <gtest/gtest.h>

#include <cmath>

#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

using Vec = std::array<double, 3>;

double dot3(const Vec& a, const Vec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec unit3(const Vec& v) {
    const double length = std::sqrt(dot3(v, v));
    return {v[0] / length, v[1] / length, v[2] / length};
}

// 0.05 (sin 9 u + cos 7 v) - 0.1, as nodes of uv0 and as a function.
const std::string waves =
    R"("s": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
       "u9": {"type": "multiply", "in": {"a": {"from": "s.x"}, "b": 9}},
       "v7": {"type": "multiply", "in": {"a": {"from": "s.y"}, "b": 7}},
       "su": {"type": "sine", "in": {"angle": {"from": "u9.result"}}},
       "cv": {"type": "cosine", "in": {"angle": {"from": "v7.result"}}},
       "sum": {"type": "add", "in": {"a": {"from": "su.result"}, "b": {"from": "cv.result"}}},
       "w": {"type": "remap", "in": {"x": {"from": "sum.result"}, "from_low": 0, "from_high": 1,
                                     "to_low": -0.1, "to_high": -0.05}}, )";
double wave(double u, double v) {
    return 0.05 * (std::sin(9 * u) + std::cos(7 * v)) - 0.1;
}

// The uv of a point of the plane: scaled by (1.5, 0.8), then turned by 30 degrees.
const std::string turned =
    R"("t": {"type": "uv_transform", "in": {"scale": [1.5, 0.8], "rotation": 30}}, )";
std::array<double, 2> turned_uv(double x, double y) {
    const double c = std::sqrt(0.75), s = 0.5;
    return {c * 1.5 * x - s * 0.8 * y, s * 1.5 * x + c * 0.8 * y};
}

struct Met {
    Vec position;
    std::array<double, 2> uv;
};

// The first point below the plane at which the ray from (x, y, 0) away from the eye is under the
// relief.
template <class Height>
Met met(Height height, bool with_turn, double x, double y, const Vec& view, double floor) {
    const auto uv_at = [&](double px, double py) {
        return with_turn ? turned_uv(px, py) : std::array{px, py};
    };
    const auto place = [&](double depth) {
        const double way = depth / view[2];
        const double px = x - view[0] * way, py = y - view[1] * way;
        return Met{{px, py, -depth}, uv_at(px, py)};
    };
    const auto under = [&](double depth) {
        const Met p = place(depth);
        return height(p.uv[0], p.uv[1]) >= p.position[2];
    };
    constexpr int steps = 20000;
    int k = 0;
    while (k < steps && !under(floor * k / steps))
        ++k;
    if (k == 0 || k == steps) return place(k == 0 ? 0 : floor);
    double above = floor * (k - 1) / steps, below = floor * k / steps;
    for (int i = 0; i < 60; ++i) {
        const double middle = (above + below) / 2;
        (under(middle) ? below : above) = middle;
    }
    return place(below);
}

std::string occlusion(const std::string& more = "") {
    return one(
        "parallax_occlusion",
        R"("height": {"from": "w.result"}, "depth": 0.2, "steps": 256, "refinements": 8)" + more);
}

const Vec views[] = {unit3({0, 0, 1}), unit3({0.5, 0.2, 1}), unit3({-1, 0.7, 0.9}),
                     unit3({1, -1, 0.5})};
const std::vector<std::array<double, 2>> places{
    {0.3, 0.6}, {-0.7, 0.2}, {0.11, -0.35}, {0.9, 0.9}, {-0.2, -0.8}};

void expect_met(bool with_turn) {
    const std::string nodes = waves + (with_turn ? turned : "") +
                              occlusion(with_turn ? R"(, "uv": {"from": "t.uv"})" : "");
    for (const Vec& view : views) {
        Scene scene{nodes, "n.uv"};
        scene.view = view;
        const auto uv = values(scene, places);
        scene.output = "n.position";
        const auto position = values(scene, places);
        scene.output = "n.height";
        const auto height = values(scene, places);
        ASSERT_EQ(uv.size(), places.size());
        for (size_t i = 0; i < places.size(); ++i) {
            const Met p = met(wave, with_turn, places[i][0], places[i][1], view, 0.2);
            EXPECT_NEAR(uv[i][0], p.uv[0], 2e-5) << i;
            EXPECT_NEAR(uv[i][1], p.uv[1], 2e-5) << i;
            EXPECT_NEAR(height[i][0], p.position[2], 2e-5) << i;
            for (size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(position[i][c], p.position[c], 2e-5) << i;
        }
    }
}

TEST(ParallaxOcclusion, IsWhereTheRayMeetsTheRelief) {
    expect_met(false);
}
TEST(ParallaxOcclusion, IsWhereTheRayMeetsTheReliefOfATurnedUv) {
    expect_met(true);
}

// One height and one scale: the bump is the slope, over the plane, of the relief at the
// intersection.
TEST(ParallaxOcclusion, BumpIsTheSlopeThatWasMet) {
    const std::string nodes = waves + turned + occlusion(R"(, "uv": {"from": "t.uv"})");
    for (const Vec& view : views) {
        Scene scene{nodes, "n.gradient"};
        scene.view = view;
        const auto gradient = values(scene, places);
        for (size_t i = 0; i < places.size(); ++i) {
            const Met p = met(wave, true, places[i][0], places[i][1], view, 0.2);
            const auto height = [&](double dx, double dy) {
                const auto uv = turned_uv(p.position[0] + dx, p.position[1] + dy);
                return wave(uv[0], uv[1]);
            };
            constexpr double d = 1e-5;
            EXPECT_NEAR(gradient[i][0], (height(d, 0) - height(-d, 0)) / (2 * d), 5e-4);
            EXPECT_NEAR(gradient[i][1], (height(0, d) - height(0, -d)) / (2 * d), 5e-4);
            EXPECT_NEAR(gradient[i][2], 0, 1e-9);
        }
    }
}

TEST(ParallaxOcclusion, NoHeightChangesNothing) {
    for (const Vec& view : views)
        for (const char* height : {R"("depth": 0.3)", R"("depth": 0, "top": 0.1)"}) {
            Scene scene{one("parallax_occlusion", height), "n.uv"};
            scene.view = view;
            EXPECT_EQ(value(scene), (std::vector<double>{0.3, 0.6}));
            scene.output = "n.detail_uv";
            EXPECT_EQ(value(scene), (std::vector<double>{0.3, 0.6}));
            scene.output = "n.position";
            EXPECT_EQ(value(scene), (std::vector<double>{0.3, 0.6, 0}));
            scene.output = "n.gradient";
            EXPECT_EQ(value(scene), (std::vector<double>{0, 0, 0}));
            scene.output = "n.lod";
            EXPECT_NEAR(value(scene)[0], 0, 1e-12);
        }
}

TEST(ParallaxOcclusion, WhatIsAboveTheTopIsCutOffAndWhatIsBelowTheDepthToo) {
    const auto depth_of = [](const std::string& in) {
        Scene scene{one("parallax_occlusion", in), "n.position"};
        scene.view = unit3({0.6, 0, 0.8});
        return value(scene);
    };
    const auto above = depth_of(R"("height": 0.5, "top": 0.2)");
    EXPECT_NEAR(above[2], 0, 1e-9);
    const auto inside = depth_of(R"("height": 0.15, "top": 0.2)");
    EXPECT_NEAR(inside[2], -0.05, 1e-9);
    EXPECT_NEAR(inside[0], 0.3 - 0.05 * 0.75, 1e-9);
    const auto below = depth_of(R"("height": -3, "top": 0.2, "depth": 0.4)");
    EXPECT_NEAR(below[2], -0.4, 1e-9);
}

TEST(ParallaxOcclusion, IsFiniteFromEverySide) {
    const std::string nodes = waves + occlusion();
    for (const Vec& view :
         {Vec{1, 0, 0}, Vec{1, 0, -1e-9}, Vec{0, 0, -1}, Vec{0, 0, 0}, unit3({1, 1, 1e-6})})
        for (const char* output : {"uv", "detail_uv", "height", "position", "gradient", "lod"}) {
            Scene scene{nodes, std::string("n.") + output};
            scene.view = view;
            for (const auto& lanes : values(scene, places))
                for (const double lane : lanes) {
                    EXPECT_TRUE(std::isfinite(lane)) << output;
                    EXPECT_LT(std::abs(lane), 40) << output;
                }
        }
}

// The area that a pixel's cone cuts out of a plane z = a + b x, by three rays from the eye.
double seen_area(const Vec& eye, const Vec& through, double a, double b) {
    constexpr double spread = 1e-6;
    const Vec to{through[0] - eye[0], through[1] - eye[1], through[2] - eye[2]};
    std::array<Vec, 3> hits;
    for (size_t i = 0; i < 3; ++i) {
        Vec d = to;
        if (i == 1) d[0] += spread * to[2], d[2] -= spread * to[0];
        if (i == 2) d[1] += spread * to[2], d[2] -= spread * to[1];
        const double way = (a + b * eye[0] - eye[2]) / (d[2] - b * d[0]);
        hits[i] = {eye[0] + way * d[0], eye[1] + way * d[1], eye[2] + way * d[2]};
    }
    Vec p, q;
    for (size_t c = 0; c < 3; ++c)
        p[c] = hits[1][c] - hits[0][c], q[c] = hits[2][c] - hits[0][c];
    return std::hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
                      p[0] * q[1] - p[1] * q[0]);
}

TEST(ParallaxOcclusion, LodIsHowMuchWiderAPixelIsOnTheRelief) {
    // z = -0.2 + 0.3 x
    const std::string slope =
        R"("s": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
           "w": {"type": "remap", "in": {"x": {"from": "s.x"}, "from_low": 0, "from_high": 1,
                                         "to_low": -0.2, "to_high": 0.1}}, )";
    const double distance = 1.7;
    for (const Vec& view : views) {
        Scene scene{
            slope + one("parallax_occlusion",
                        R"("height": {"from": "w.result"}, "depth": 1, "eye_distance": 1.7)"),
            "n.lod"};
        scene.view = view;
        const Vec place{0.3, 0.6, 0};
        Vec eye = place;
        for (size_t c = 0; c < 3; ++c)
            eye[c] += distance * view[c];
        const double wider = seen_area(eye, place, -0.2, 0.3) / seen_area(eye, place, 0, 0);
        EXPECT_NEAR(value(scene)[0], 0.5 * std::log2(wider), 1e-4);
    }
}

// A texture read at the shifted uv has the footprint of the unshifted uv, with the detail of the
// relief.
TEST(ParallaxOcclusion, ReadsHaveTheFootprintOfTheSurfaceAlsoWhereTheUvJumps) {
    const std::string nodes =
        waves + occlusion() +
        R"(, "i": {"type": "gradient_from_height", "in": {"height": {"from": "r.x"}}},
                  "r": {"type": "separate_vec2", "in": {"vector": {"from": "n.uv"}}},
                  "k": {"type": "gradient_from_height", "in": {"height": {"from": "q.x"}}},
                  "q": {"type": "separate_vec2", "in": {"vector": {"from": "n.detail_uv"}}})";
    Scene scene{nodes, "i.gradient"};
    scene.view = views[3];
    for (const auto& change : values(scene, places)) {
        EXPECT_NEAR(change[0], 1, 1e-9);
        EXPECT_NEAR(change[1], 0, 1e-9);
    }
    scene.output = "k.gradient";
    const auto detail = values(scene, places);
    scene.output = "n.lod";
    const auto lod = values(scene, places);
    for (size_t i = 0; i < places.size(); ++i)
        EXPECT_NEAR(detail[i][0], std::exp2(lod[i][0]), 1e-6);
}

TEST(ParallaxOffset, GoesWhereTheViewIsAtThatHeight) {
    const std::string nodes = waves + turned;
    const auto shifted = [&](const char* method) {
        return one(
            "parallax_offset",
            R"("height": {"from": "w.result"}, "uv": {"from": "t.uv"}, "middle": -0.1, "method": ")" +
                std::string(method) + "\"");
    };
    for (const Vec& view : views)
        for (const bool full : {false, true}) {
            Scene scene{nodes + shifted(full ? "full" : "limited"), "n.uv"};
            scene.view = view;
            const auto uv = values(scene, places);
            for (size_t i = 0; i < places.size(); ++i) {
                const auto [x, y] = places[i];
                const auto start = turned_uv(x, y);
                const double way = (wave(start[0], start[1]) + 0.1) / (full ? view[2] : 1);
                const auto end = turned_uv(x + way * view[0], y + way * view[1]);
                EXPECT_NEAR(uv[i][0], end[0], 1e-6);
                EXPECT_NEAR(uv[i][1], end[1], 1e-6);
            }
        }
}

}  // namespace
}  // namespace wrinkle::test

// Tests of coordinates made of position, and of triplanar maps: against the sides as seen from
// outside, against published closed forms, and against displaced surfaces.
#include <gtest/gtest.h>

#include <cmath>

#include "nodes/solid.h"

namespace wrinkle::test {
namespace {

const std::vector<double> scales{1, 2.5, -1.5};

std::string number(double x) {
    return std::to_string(x);
}
const char* axis_name(int side) {
    constexpr const char* names[] = {"x", "y", "z"};
    return names[side / 2];
}

// h(u, v), its graph over the given uv, and its slopes.
constexpr double amplitude = 0.0004, waves_u = 300, waves_v = 170;
double relief(double u, double v) {
    return amplitude * (std::sin(waves_u * u) + 0.5 * std::sin(waves_v * v + 1));
}
std::string relief_of(const std::string& uv) {
    const std::string a = number(amplitude), half = number(amplitude / 2);
    return R"("uv": {"type": "separate_vec2", "in": {"vector": {"from": ")" + uv + R"("}}},
        "au": {"type": "multiply", "in": {"a": {"from": "uv.x"}, "b": )" +
           number(waves_u) + R"(}},
        "av": {"type": "multiply", "in": {"a": {"from": "uv.y"}, "b": )" +
           number(waves_v) + R"(}},
        "bv": {"type": "add", "in": {"a": {"from": "av.result"}, "b": 1}},
        "su": {"type": "sine", "in": {"angle": {"from": "au.result"}}},
        "sv": {"type": "sine", "in": {"angle": {"from": "bv.result"}}},
        "hu": {"type": "multiply", "in": {"a": {"from": "su.result"}, "b": )" +
           a + R"(}},
        "hv": {"type": "multiply", "in": {"a": {"from": "sv.result"}, "b": )" +
           half + R"(}},
        "h": {"type": "add", "in": {"a": {"from": "hu.result"}, "b": {"from": "hv.result"}}})";
}
const std::string bump_of_h =
    R"(, "g": {"type": "gradient_from_height", "in": {"height": {"from": "h.result"}}})";

Vector normal_after(Vector n, const std::vector<double>& gradient) {
    return unit(n - vector_of(gradient));
}

// Mean and maximum angle between bump and reference, and the maximum tilt of the reference.
struct Errors {
    double worst = 0, most = 0;
};
Errors errors_on_sphere(const Scene& scene, const std::function<double(Vector, Vector)>& height,
                        int count = 400) {
    Errors errors;
    const auto places = on_sphere(count);
    const auto gradients = values_on(scene, places);
    for (size_t i = 0; i < gradients.size(); ++i) {
        const Vector n = places[i].normal;
        EXPECT_NEAR(dot(n, vector_of(gradients[i])), 0, 1e-9);
        const Vector truth = displaced_on_sphere(n, [&](Vector p) { return height(p, n); });
        errors.worst = std::fmax(errors.worst, angle_deg(normal_after(n, gradients[i]), truth));
        errors.most = std::fmax(errors.most, angle_deg(n, truth));
    }
    return errors;
}

TEST(Pitfall23FlippedAxes, ProjectionsReadTheRightWayRoundOnSixSides) {
    for (const char* type : {"planar_uv", "box_uv"})
        for (int index = 0; index < 6; ++index) {
            SCOPED_TRACE(std::string(type) + " on side " + std::to_string(index));
            const std::string in =
                std::string(R"("scale": [2, 3])") +
                (type[0] == 'p' ? std::string(R"(, "axis": ")") + axis_name(index) + "\"" : "");
            const Scene scene{one(type, in), "n.uv"};
            const Seen seen = seen_from_outside(index);
            const Vector n = side(index), p = n + seen.right * 0.2 - seen.up * 0.3;
            const auto uv = value_on(scene, {p, n});
            const auto right = value_on(scene, {p + seen.right * 0.1, n});
            const auto above = value_on(scene, {p + seen.up * 0.1, n});
            EXPECT_NEAR(right[0] - uv[0], 0.2, 1e-9);
            EXPECT_NEAR(right[1] - uv[1], 0, 1e-9);
            EXPECT_NEAR(above[0] - uv[0], 0, 1e-9);
            EXPECT_NEAR(above[1] - uv[1], 0.3, 1e-9);
        }
}

TEST(Pitfall23FlippedAxes, TriplanarColorsReadTheRightWayRoundOnSixSides) {
    const Image ramp = painted(64, [](double u, double v) { return std::array{u, v, 0.0}; });
    const Scene scene{
        R"("n": {"type": "triplanar_color", "in": {"image": {"file": "textures/weave_normal.png",
            "encoding": "linear"}}})",
        "n.color", ramp};
    for (int index = 0; index < 6; ++index) {
        const Seen seen = seen_from_outside(index);
        const Vector n = side(index), p = seen.right * 0.3 + seen.up * 0.6 + n * 7.25;
        const auto color = value_on(scene, {p, n});
        EXPECT_NEAR(color[0], 0.3, 1e-3) << index;
        EXPECT_NEAR(color[1], 0.6, 1e-3) << index;
    }
}

TEST(PlanarUv, WeighsTheSideThatIsMet) {
    const auto weight = [](const std::string& in, Vector n) {
        const Vector normal = unit(n);
        return value_on({one("planar_uv", in), "n.weight"}, {normal, normal})[0];
    };
    const Vector up{0, 1, 0}, down{0, -1, 0}, aside{1, 0.1, 0};
    EXPECT_EQ(weight("", up), 1);
    EXPECT_EQ(weight("", down), 1);
    EXPECT_EQ(weight(R"("side": "positive")", down), 0);
    EXPECT_EQ(weight(R"("side": "negative")", down), 1);
    EXPECT_EQ(weight(R"("side": "negative")", up), 0);
    EXPECT_EQ(weight("", aside), 0);
    const Vector half{std::sqrt(1 - 0.35 * 0.35), 0.35, 0};  // midway between 0.2 and 0.5
    EXPECT_NEAR(weight("", half), 0.5, 1e-9);
    EXPECT_EQ(weight(R"("limit": 0.34, "falloff": 0)", half), 1);
    EXPECT_EQ(weight(R"("limit": 0.36, "falloff": 0)", half), 0);
}

// Golubev, eqs. 44 and 50: with the lookup's axes p and q, the volume gradient of a planar map is
// d.u p + d.v q, and the bump is its image under I - n n^T.
TEST(PlanarUv, ClosedFormIsTheVolumeForm) {
    const Image slopes = painted(8, [](double, double) { return std::array{0.75, 0.375, 0.0}; });
    for (int index = 0; index < 6; ++index)
        for (const double scale : scales) {
            SCOPED_TRACE(std::to_string(index) + ", scale " + number(scale));
            const std::string planar =
                std::string(R"("p": {"type": "planar_uv", "in": {"axis": ")") + axis_name(index) +
                R"(", "scale": [)" + number(scale) + ", " + number(2 * scale) + "]}}, ";
            const Scene scene{planar + one("derivative_map", R"("uv": {"from": "p.uv"})"),
                              "n.gradient", slopes};
            const Seen seen = seen_from_outside(index);
            const Vector n = unit(side(index) + seen.right * 0.4 - seen.up * 0.7);
            const Vector volume = seen.right * (0.5 * scale) + seen.up * (-0.25 * 2 * scale);
            const Vector expected = volume - n * dot(n, volume);
            const Vector got = vector_of(value_on(scene, {n, n}));
            EXPECT_LT(std::sqrt(dot(got - expected, got - expected)), 1e-6);
        }
}

TEST(PlanarUv, BumpsAsASphereThatIsDisplaced) {
    for (int index = 0; index < 6; index += 2) {
        const std::string planar = std::string(R"("p": {"type": "planar_uv", "in": {"axis": ")") +
                                   axis_name(index) + R"("}}, )";
        const Errors errors = errors_on_sphere(
            {planar + relief_of("p.uv") + bump_of_h, "g.gradient"}, [&](Vector p, Vector n) {
                const int met = index + (dot(n, side(index)) < 0 ? 1 : 0);
                const Seen seen = seen_from_outside(met);
                return relief(dot(p, seen.right), dot(p, seen.up));
            });
        EXPECT_LT(errors.worst, 0.05);
        EXPECT_GT(errors.most, 5);
    }
}

// Each of the other projections against its closed form, and its bump against displacement.
struct Projection {
    const char* name;
    std::string in;
    std::array<double, 2> (*uv)(Vector p);
};
const Projection projections[] = {
    {"plane_uv", R"("origin": [0.1, 0.2, 0.3], "normal": [2, 0, 2], "up": [0, 3, 1])",
     [](Vector p) {
         const Vector n = unit({1, 0, 1}), v = unit(Vector{0, 3, 1} - n * dot({0, 3, 1}, n));
         const Vector way = p - Vector{0.1, 0.2, 0.3};
         return std::array{dot(way, cross(v, n)), dot(way, v)};
     }},
    {"cylinder_uv", R"("origin": [0.1, 0.2, 0.3])",
     [](Vector p) {
         return std::array{std::atan2(p.x - 0.1, p.z - 0.3) / full_circle + 0.5, p.y - 0.2};
     }},
    {"sphere_uv", R"("origin": [0.1, 0.2, 0.3], "axis": [1, 0, 0], "front": [0, 1, 0])",
     [](Vector p) {
         // From +y with +x up, right is +z.
         const Vector way = unit(p - Vector{0.1, 0.2, 0.3});
         return std::array{std::atan2(way.z, way.y) / full_circle + 0.5,
                           std::asin(way.x) / (full_circle / 2) + 0.5};
     }},
    {"decal_cone", R"("origin": [0, 0, 3], "angle": 90)",
     [](Vector p) {
         const double ahead = 3 - p.z;
         return std::array{0.5 + 0.5 * p.x / ahead, 0.5 + 0.5 * p.y / ahead};
     }},
    {"decal_box", R"("origin": [0, 2, 0], "direction": [0, -1, 0], "up": [0, 0, -1],
        "size": [2, 4, 8])",
     [](Vector p) {
         return std::array{0.5 + p.x / 2, 0.5 - p.z / 4};
     }},
    {"decal_sphere", R"("origin": [0.1, 0.2, 0.3])",
     [](Vector p) {
         const Vector way = unit(p - Vector{0.1, 0.2, 0.3});
         return std::array{std::atan2(way.x, way.z) / full_circle + 0.5,
                           std::asin(way.y) / (full_circle / 2) + 0.5};
     }},
    {"decal_capsule", R"("start": [0, -3, 0.2], "end": [0, 3, 0.2])",
     [](Vector p) {
         return std::array{std::atan2(p.x, p.z - 0.2) / full_circle + 0.5, (p.y + 3) / 6};
     }},
};

TEST(Projections, UvsAreTheClosedForms) {
    const auto places = on_sphere(200);
    for (const Projection& projection : projections) {
        SCOPED_TRACE(projection.name);
        const auto uvs = values_on({one(projection.name, projection.in), "n.uv"}, places);
        for (size_t i = 0; i < uvs.size(); ++i) {
            const auto expected = projection.uv(places[i].position);
            EXPECT_NEAR(uvs[i][0], expected[0], 1e-7);
            EXPECT_NEAR(uvs[i][1], expected[1], 1e-7);
        }
    }
}

TEST(Projections, BumpAsASphereThatIsDisplaced) {
    for (const Projection& projection : projections) {
        SCOPED_TRACE(projection.name);
        const Errors errors = errors_on_sphere(
            {one(projection.name, projection.in) + ", " + relief_of("n.uv") + bump_of_h,
             "g.gradient"},
            [&](Vector p, Vector) {
                const auto uv = projection.uv(p);
                return relief(uv[0], uv[1]);
            });
        EXPECT_LT(errors.worst, 0.1);
        EXPECT_GT(errors.most, 0.5);
    }
}

// Castano's weights, computed explicitly.
std::array<double, 3> weights_of(Vector n, double sharpness) {
    std::array<double, 3> w{std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
    double sum = 0;
    for (double& each : w)
        sum += each = std::pow(std::fmax(each - 0.2, 0), sharpness);
    for (double& each : w)
        each /= sum;
    return w;
}

TEST(Triplanar, WeightsAreThoseOfTheNormal) {
    for (const double sharpness : {1.0, 3.0, 8.0})
        for (const Place& place : on_sphere(50)) {
            const std::string in = R"("sharpness": )" + number(sharpness);
            const auto got = value_on({one("triplanar_weights", in), "n.weights"}, place);
            const auto expected = weights_of(place.normal, sharpness);
            for (size_t i = 0; i < 3; ++i)
                EXPECT_NEAR(got[i], expected[i], 1e-9);
        }
    const std::string zero = R"("normal": [0, 0, 0])";
    const auto none = value_on({one("triplanar_weights", zero), "n.weights"}, {{1, 0, 0}, {}});
    EXPECT_EQ(none, (std::vector<double>{0, 0, 0}));
}

// For each axis, the height on the side that the normal faces, as seen from outside.
double seen_height(Vector p, Vector n, double tiling) {
    const auto w = weights_of(n, 3);
    double height = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const int met = 2 * axis + (dot(n, side(2 * axis)) < 0 ? 1 : 0);
        const Seen seen = seen_from_outside(met);
        height += w[static_cast<size_t>(axis)] *
                  relief(tiling * dot(p, seen.right), tiling * dot(p, seen.up));
    }
    return height;
}

TEST(Pitfall23FlippedAxes, TriplanarHeightsAreLitAsASphereThatIsDisplaced) {
    for (const double tiling : {1.0, -1.3}) {
        const std::string in = R"("height": {"from": "h.result"}, "tiling": )" + number(tiling);
        const Errors errors = errors_on_sphere(
            {relief_of("surface.uv0") + ", " + one("triplanar_height", in), "n.gradient"},
            [&](Vector p, Vector n) { return seen_height(p, n, tiling); });
        EXPECT_LT(errors.worst, 0.05);
        EXPECT_GT(errors.most, 5);
    }
}

// The volume form of slopes (A1 #9) against a relief of the same slopes, on cubes and on spheres.
TEST(Pitfall23FlippedAxes, TriplanarSlopesAreThoseOfTheRelief) {
    const Image flat_slopes = painted(8, [](double, double) {
        return std::array{0.75, 0.375, 0.0};
    });
    const auto plane = [](Vector p, Vector n, double tiling) {
        const auto w = weights_of(n, 3);
        double height = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const int met = 2 * axis + (dot(n, side(2 * axis)) < 0 ? 1 : 0);
            const Seen seen = seen_from_outside(met);
            height += w[static_cast<size_t>(axis)] * tiling *
                      (0.5 * dot(p, seen.right) - 0.25 * dot(p, seen.up));
        }
        return height;
    };
    auto places = on_sphere(100);
    for (int index = 0; index < 6; ++index)
        places.push_back({side(index), side(index)});
    for (const double tiling : scales) {
        const std::string in = R"("tiling": )" + number(tiling);
        const Scene scene{one("triplanar_derivative_map", in), "n.gradient", flat_slopes};
        const auto gradients = values_on(scene, places);
        for (size_t i = 0; i < gradients.size(); ++i) {
            const Vector n = places[i].normal;
            EXPECT_NEAR(dot(n, vector_of(gradients[i])), 0, 1e-9);
            const Vector truth =
                displaced_on_plane(places[i], [&](Vector p) { return plane(p, n, tiling); });
            EXPECT_LT(angle_deg(normal_after(n, gradients[i]), truth), 1e-4);
        }
    }
}

TEST(Triplanar, NormalMapsAndFieldsAreTheirSlopes) {
    // (-0.6, 0.2, 0.5): slopes 1.2 and -0.4
    const Image normals = painted(8, [](double, double) { return std::array{0.2, 0.6, 0.75}; });
    const std::string field =
        R"("m": {"type": "tangent_normal_map", "in": {"image": "textures/weave_normal.png"}}, )" +
        one("triplanar_derivative", R"("derivative": {"from": "m.derivative"}, "scale": "unit")");
    for (const Place& place : on_sphere(40)) {
        const auto direct =
            value_on({one("triplanar_normal_map", R"("tiling": 3)"), "n.gradient", normals}, place);
        const auto through = value_on({field, "n.gradient", normals}, place);
        const auto w = weights_of(place.normal, 3);
        Vector volume;
        for (int axis = 0; axis < 3; ++axis) {
            const int met = 2 * axis + (dot(place.normal, side(2 * axis)) < 0 ? 1 : 0);
            const Seen seen = seen_from_outside(met);
            volume = volume + (seen.right * 1.2 - seen.up * 0.4) * w[static_cast<size_t>(axis)];
        }
        const Vector expected = volume - place.normal * dot(place.normal, volume);
        for (const auto& got : {direct, through}) {
            const Vector off = vector_of(got) - expected;
            EXPECT_LT(std::sqrt(dot(off, off)), 1e-5);
        }
    }
}

// T6: if one weight is 1, triplanar is planar.
TEST(Triplanar, WithOneWeightIsPlanar) {
    const Image waves = painted(64, [](double u, double v) {
        return std::array{0.5 + 0.3 * std::sin(full_circle * u),
                          0.5 + 0.2 * std::sin(full_circle * (u + v)), 0.0};
    });
    for (int index = 0; index < 6; ++index) {
        const Seen seen = seen_from_outside(index);
        const Vector n = unit(side(index) + seen.right * 0.1 + seen.up * 0.15);
        const Place place{n + seen.right * 0.37, n};
        const std::string planar = std::string(R"("p": {"type": "planar_uv", "in": {"axis": ")") +
                                   axis_name(index) + R"("}}, )" +
                                   one("derivative_map", R"("uv": {"from": "p.uv"})");
        const auto expected = value_on({planar, "n.gradient", waves}, place);
        const auto got = value_on({one("triplanar_derivative_map"), "n.gradient", waves}, place);
        for (size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(got[i], expected[i], 1e-6);
        EXPECT_GT(dot(vector_of(got), vector_of(got)), 1e-4);
    }
}

TEST(BoxUv, ChoosesTheSideOfTheLargestComponent) {
    for (int index = 0; index < 6; ++index) {
        const Seen seen = seen_from_outside(index);
        const Vector n = unit(side(index) + seen.right * 0.9 - seen.up * 0.8);
        EXPECT_EQ(value_on({one("box_uv"), "n.face"}, {n, n})[0], index);
    }
}

// A direction along `up`, or a zero direction, gives finite results.
TEST(Projections, ParallelAndZeroAxesAreFinite) {
    for (const char* in : {R"("normal": [0, 1, 0], "up": [0, 2, 0])", R"("normal": [0, 0, 0])",
                           R"("up": [0, 0, 0])"})
        for (const double lane : value_on({one("plane_uv", in), "n.uv"}, {{1, 2, 3}, {0, 0, 1}}))
            EXPECT_TRUE(std::isfinite(lane));
    const auto uv = value_on({one("plane_uv", R"("normal": [0, 1, 0], "up": [0, 2, 0])"), "n.uv"},
                             {{1, 2, 3}, {0, 1, 0}});
    EXPECT_NEAR(std::hypot(uv[0], uv[1]), std::hypot(1, 3), 1e-9);  // still a plane
}

}  // namespace
}  // namespace wrinkle::test

// Tests of the properties T1 to T5 and T7 that follow from Mikkelsen's framework: resolve, tangent
// normals, generated frames, object-space normals, and the meaning of a scale. T6, T8 and T12 are
// tests of nodes; T10 is HeightSlope, T13 EveryBump; the others are in the neighbouring files.
#include <gtest/gtest.h>

#include <cmath>

#include "property/in_float.h"

namespace wrinkle::test {
namespace {

void set_normal(Surroundings& around, dvec3 n) {
    set(around, SurfaceInput::normal_, {n.x, n.y, n.z});
}

// A free vector of the point, as from a map.

TEST(Reference, T1_WhatIsResolvedIsNeverShorterThanTheNormal) {
    Material m;
    const Value free = m.input(free_vector).xyz();
    m.output("volume", m.vector_of(m.from_volume(free)));
    m.output("map", m.vector_of(m.from_tangent_normal(
                        free, m.frame(m.uv0(), WR_FRAME_derived, WR_SCALE_unit))));
    m.output("height", m.vector_of(m.from_height(m.sin(dot(m.position(), free)))));
    m.output("normal", m.vector_of(m.from_normal(free)));
    const Expanded material(m);
    for (const Sample& sample : samples(200, 51)) {
        Surroundings around = point_at(torus(), sample.st, sample.pixel);
        set_free(around, dvec3(std::sin(sample.st.x * 9), std::cos(sample.st.y * 7), 0.3) * 1.7);
        const dvec3 n = normal_of(around);
        for (size_t output = 0; output < 4; ++output) {
            const dvec3 gamma = material.vector(output, around);
            EXPECT_NEAR(glm::dot(n, gamma), 0, 1e-6 * (1 + glm::length(gamma)));
            EXPECT_GE(glm::length(n - gamma), 1 - 1e-6);
        }
    }
}

TEST(Reference, T1_AFlatBumpGivesTheUnitNormalBitForBit) {
    Material m;
    m.output("flat", m.resolve(m.flat()));
    m.output("level", m.resolve(m.from_height(m.number(2))));
    const Expanded material(m);
    const InFloat in_float(material);
    for (const dvec3 n : {dvec3(0, 0, 1), dvec3(-1, 0, 0), dvec3(0.6, 0, 0.8), dvec3(0, -0.8, 0.6),
                          dvec3(0.5, 0.5, 0.70710678)}) {
        Surroundings around = point_at(sphere(), dvec2(0.2, 0.3), dmat2(1e-3));
        set_normal(around, n);
        for (size_t output = 0; output < 2; ++output) {
            const dvec3 got = in_float.vector(output, around);
            for (int i = 0; i < 3; ++i)
                EXPECT_FLOAT_EQ(static_cast<float>(got[i]), static_cast<float>(n[i]));
            if (n.x * n.x + n.y * n.y + n.z * n.z == 1) {
                EXPECT_EQ(material.vector(output, around), n);
            }
        }
    }
}

// MikkTSpace's decode, computed explicitly: m.x T + m.y B + m.z N from rasteriser interpolants.
TEST(Reference, T2_VertexFrameEqualsMikkTSpaceDecode) {
    Material m;
    m.output("normal",
             m.resolve(m.from_tangent_normal(m.input(free_vector).xyz(),
                                             m.frame(m.uv0(), WR_FRAME_vertex, WR_SCALE_unit))));
    const Expanded material(m);
    const InFloat in_float(material);
    double length = 0.3, steepest = 0;
    for (const Sample& sample : samples(400, 52)) {
        Surroundings around = point_at(torus(), sample.st, sample.pixel);
        const dvec3 n = normal_of(around) * length;
        const dvec3 t = dvec3(std::cos(sample.st.x), sample.st.y, std::sin(sample.st.x)) * 0.7;
        const double w = sample.st.y > 0 ? 1 : -1;
        const dvec3 map(std::sin(sample.st.x * 5), std::cos(sample.st.y * 11), 0.011 + length);
        set_normal(around, n);
        set(around, SurfaceInput::tangent_, {t.x, t.y, t.z, w});
        set_free(around, map);
        const dvec3 b = glm::cross(n, t) * w;
        const dvec3 decoded = glm::normalize(t * map.x + b * map.y + n * map.z);
        EXPECT_LE(angle_deg(material.vector(0, around), decoded), 1e-6);
        EXPECT_LE(angle_deg(in_float.vector(0, around), decoded), 1e-3);
        steepest = std::fmax(steepest, angle_deg(decoded, n));
        length = length > 1 ? 0.3 : length + 0.01;
    }
    EXPECT_GT(steepest, 60);
}

struct Tilt {
    dvec3 map;
    double degrees;
};

TEST(Reference, T3_SteepAndDegenerateTangentNormals) {
    const double byte = 2 * 127 / 255.0 - 1;
    const Tilt tilts[] = {
        {{1, 0, 0}, 89.552},
        {{0, -1, 0}, 89.552},
        {{0.7, 0.7, 0.001}, 89.683},
        {{0, 1, -0.1}, std::atan(10.0) * degrees},
        {{0, 0, -1}, 0},
        {{0, 0, 0}, 0},
        {{byte, 0, 1}, 0.22469},
        {{byte, -byte, 1}, std::atan(std::sqrt(2.0) / 255) * degrees},
    };
    for (const uint32_t method : {WR_FRAME_vertex, WR_FRAME_derived}) {
        Material m;
        m.output("normal",
                 m.resolve(m.from_tangent_normal(m.input(free_vector).xyz(),
                                                 m.frame(m.uv0(), method, WR_SCALE_unit))));
        const Expanded material(m);
        const InFloat in_float(material);
        for (const Tilt& tilt : tilts) {
            Surroundings around = point_at(sphere(), dvec2(0.4, 0.3), dmat2(0.01));
            set_free(around, tilt.map);
            const dvec3 n = normal_of(around);
            EXPECT_NEAR(angle_deg(material.vector(0, around), n), tilt.degrees, 5e-4);
            EXPECT_NEAR(angle_deg(in_float.vector(0, around), n), tilt.degrees, 1e-2);
        }
    }
}

// The direction on the surface in which u grows and v is constant, and the side on which v grows.
struct Walk {
    dvec3 t, b;
};
Walk walk(const Surface& surface, dvec2 st, const std::function<dvec2(dvec2)>& uv) {
    const dmat2 uv_of_st(along(uv, st, dvec2(1, 0), 1e-3), along(uv, st, dvec2(0, 1), 1e-3));
    const dmat2 st_of_uv = glm::inverse(uv_of_st);
    const auto towards = [&](dvec2 way) {
        return glm::normalize(along(surface.position, st, way / glm::length(way), 1e-3));
    };
    const dvec3 t = towards(st_of_uv[0]), v = towards(st_of_uv[1]);
    return {t, glm::normalize(v - t * glm::dot(v, t))};
}

struct TurnedUv {
    const char* name;
    dmat2 turn;
};
const TurnedUv turned_uvs[] = {
    {"plain", dmat2(1)},
    {"rotated", dmat2(std::cos(0.8), std::sin(0.8), -std::sin(0.8), std::cos(0.8))},
    {"mirrored_u", dmat2(-1, 0, 0, 1)},
    {"mirrored_v", dmat2(1, 0, 0, -1)},
    {"skewed", dmat2(1, 0.3, 0.6, 1)},
    {"stretched_and_mirrored", dmat2(-0.2, 0.1, 0.4, 3)},
};
class GeneratedFrame : public testing::TestWithParam<TurnedUv> {};

// uv1 of the surfaces is bent as well, and in addition rotated in the mesh.
Surface turned(Surface surface) {
    const auto uv1 = surface.uv1;
    const dmat2 turn = GeneratedFrame::GetParam().turn;
    surface.uv1 = [=](dvec2 st) { return turn * uv1(st); };
    return surface;
}

TEST_P(GeneratedFrame, T4_FollowsTheUvsWhateverScreenTilingAndNormal) {
    Material m;
    for (const double tiles : {1.0, 9.0})
        for (const dvec2 slope : {dvec2(1, 0), dvec2(0, 1)})
            m.output("axis", m.vector_of(m.from_slope(
                                 m.vector(slope),
                                 m.frame(m.uv1() * tiles, WR_FRAME_derived, WR_SCALE_unit))));
    const Expanded material(m);
    for (const Surface& surface : {turned(sphere()), turned(torus())})
        for (const Sample& sample : samples(60, 53)) {
            const Walk expected = walk(surface, sample.st, surface.uv1);
            const dmat2 upside_down(sample.pixel[0], -sample.pixel[1]);
            for (const dmat2& pixel : {sample.pixel, upside_down})
                for (const double side : {1.0, -1.0}) {
                    Surroundings around = point_at(surface, sample.st, pixel);
                    set_normal(around, normal_of(around) * side);
                    for (const size_t tiled : {0U, 2U}) {
                        const dvec3 t = material.vector(tiled, around);
                        const dvec3 b = material.vector(tiled + 1, around);
                        EXPECT_LE(glm::distance(t, expected.t), 1e-6);
                        EXPECT_LE(glm::distance(b, expected.b), 1e-6);
                    }
                }
        }
}

INSTANTIATE_TEST_SUITE_P(Reference, GeneratedFrame, testing::ValuesIn(turned_uvs),
                         [](const auto& instance) { return instance.param.name; });

// u = x + k y: the exact gradient of a slope (a, b) is a (1, k) + b (0, 1), and an orthonormal
// frame omits a k.
TEST(Reference, T4_ADerivedFrameLosesSkewAndAnExactOneKeepsIt) {
    const double k = 0.7, a = 0.3, b = -0.2;
    const Surface plane = plane_with(dmat2(1, 0, k, 1));
    const dvec3 x = along(plane.position, dvec2(0), dvec2(1, 0), 1e-2);
    const dvec3 y = along(plane.position, dvec2(0), dvec2(0, 1), 1e-2);
    Material m;
    const Value slope = m.vector(dvec2(a, b));
    m.output("derived",
             m.vector_of(m.from_slope(slope, m.frame(m.uv0(), WR_FRAME_derived, WR_SCALE_unit))));
    m.output("exact",
             m.vector_of(m.from_slope(slope, m.frame(m.uv0(), WR_FRAME_exact, WR_SCALE_surface))));
    const Expanded material(m);
    for (const Sample& sample : samples(20, 54)) {
        const Surroundings around = point_at(plane, sample.st, sample.pixel);
        EXPECT_LE(glm::distance(material.vector(0, around), x * a + y * b), 1e-6);
        EXPECT_LE(glm::distance(material.vector(1, around), x * a + y * (b + a * k)), 1e-6);
    }
}

TEST(Reference, T4_UvsWithoutAnAreaGiveAFiniteBumpAndNoneAtAllIsFlat) {
    Material m;
    m.output("normal", m.resolve(m.from_slope(m.vector(dvec2(0.6, -0.8)),
                                              m.frame(m.uv1(), WR_FRAME_derived, WR_SCALE_unit))));
    const Expanded material(m);
    const InFloat in_float(material);
    Surroundings around = point_at(torus(), dvec2(0.4, 0.3), dmat2(0.01, 0.002, -0.001, 0.01));
    const dvec3 n = normal_of(around);
    set(around, SurfaceInput::uv1_, {0, 0}, Variant::dx);
    set(around, SurfaceInput::uv1_, {0, 0}, Variant::dy);
    EXPECT_LE(glm::distance(material.vector(0, around), n), 1e-12);
    EXPECT_LE(glm::distance(in_float.vector(0, around), n), 1e-6);
    for (const dvec2 along_line : {dvec2(0.01, 0.02), dvec2(0, 0.01), dvec2(-0.03, 0)})
        for (const double ratio : {2.0, -1.0, 0.0}) {
            set(around, SurfaceInput::uv1_, {along_line.x, along_line.y}, Variant::dx);
            set(around, SurfaceInput::uv1_, {ratio * along_line.x, ratio * along_line.y},
                Variant::dy);
            for (const dvec3 got : {material.vector(0, around), in_float.vector(0, around)}) {
                EXPECT_NEAR(glm::length(got), 1, 1e-6);
                EXPECT_LE(angle_deg(got, n), 45.001) << "a slope of length 1";
            }
        }
}

}  // namespace
}  // namespace wrinkle::test

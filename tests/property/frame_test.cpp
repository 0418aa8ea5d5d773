// Tests of tangent-space normal maps: the world-space bump must equal that of displacing the
// surface by the map's height, for uvs that are rotated, mirrored or tiled.
//
// On a developable surface with an isometric uv, dh/d(u,v) is a slope on the surface. The map's
// normal is computed from a small patch of the height field, lifted and differentiated.
#include <gtest/gtest.h>

#include <cmath>

#include "property/material.h"

namespace wrinkle::test {
namespace {

// A height over the plane of the map, smooth, without symmetry.
double map_height(dvec2 uv) {
    return 0.02 * std::sin(7 * uv.x + 1) * std::cos(3 * uv.y) + 0.05 * uv.x - 0.03 * uv.y * uv.x;
}

// The normal that a baker stores for the lifted patch: x along u, y along v, green = +v.
dvec3 map_normal(dvec2 uv) {
    const auto lifted = [](dvec2 p) { return dvec3(p.x, p.y, map_height(p)); };
    return glm::normalize(
        glm::cross(along(lifted, uv, dvec2(1, 0), 1e-4), along(lifted, uv, dvec2(0, 1), 1e-4)));
}

dmat2 rotation(double angle) {
    return {std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle)};
}
const dmat2 mirror_u(-1, 0, 0, 1), mirror_v(1, 0, 0, -1);

// The maps are isometries; `uv_of` is the graph's transformation of uv0 before the texture lookup.
struct UvCase {
    const char* name;
    dmat2 uv0_of_length;
    dmat2 uv_of_uv0;
};

const UvCase uv_cases[] = {
    {"plain", dmat2(1), dmat2(1)},
    {"rotated_mesh_uv", rotation(0.9), dmat2(1)},
    {"mirrored_mesh_u", mirror_u, dmat2(1)},
    {"mirrored_mesh_v", mirror_v* rotation(2.2), dmat2(1)},
    {"rotated_in_the_graph", dmat2(1), rotation(0.7)},
    {"mirrored_in_the_graph", dmat2(1), mirror_u},
    {"all_of_it", mirror_v* rotation(1.1), rotation(-0.4) * mirror_u},
};

class NormalMap : public testing::TestWithParam<UvCase> {};

void expect_displaced(const Expanded& material, size_t output, const Surface& surface,
                      const dmat2& uv_of_uv0, double tolerance_deg) {
    const auto uv = [&](dvec2 st) { return uv_of_uv0 * surface.uv0(st); };
    for (const Sample& sample : samples(60, 17)) {
        const dvec3 m = map_normal(uv(sample.st));
        Surroundings around = point_at(surface, sample.st, sample.pixel);
        set(around, texel, {m.x, m.y, m.z, 1});
        // Small enough to make curvature negligible: slopes are of the map, not of the size.
        const dvec3 truth = displaced_normal(
            surface, [&](dvec2 st) { return map_height(uv(st)) - map_height(uv(sample.st)); },
            sample.st);
        EXPECT_LE(angle_deg(material.vector(output, around), truth), tolerance_deg);
    }
}

TEST_P(NormalMap, BumpsTheWayTheSurfaceWould) {
    for (const uint32_t method : {WR_FRAME_vertex, WR_FRAME_derived, WR_FRAME_auto}) {
        Material m;
        const dmat2& a = GetParam().uv_of_uv0;
        const Value uv = vec2(dot(m.uv0(), m.vector(dvec2(a[0].x, a[1].x))),
                              dot(m.uv0(), m.vector(dvec2(a[0].y, a[1].y))));
        m.output("normal", m.resolve(m.from_tangent_normal(m.texel_normal(),
                                                           m.frame(uv, method, WR_SCALE_unit))));
        const Expanded material(m);
        for (const Surface& surface :
             {plane_with(GetParam().uv0_of_length), cylinder_with(GetParam().uv0_of_length)}) {
            SCOPED_TRACE(std::string(surface.name) + ", frame " + std::to_string(method));
            expect_displaced(material, 0, surface, a, 1e-4);
        }
    }
}

// The same map if only this uv set is known, and with the exact frame, which takes any uv.
TEST_P(NormalMap, WorksInAnExactFrameToo) {
    Material m;
    const dmat2& a = GetParam().uv_of_uv0;
    const Value uv = vec2(dot(m.uv0(), m.vector(dvec2(a[0].x, a[1].x))),
                          dot(m.uv0(), m.vector(dvec2(a[0].y, a[1].y))));
    m.output("normal", m.resolve(m.from_tangent_normal(
                           m.texel_normal(), m.frame(uv, WR_FRAME_exact, WR_SCALE_surface))));
    const Expanded material(m);
    expect_displaced(material, 0, cylinder_with(GetParam().uv0_of_length), a, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Uvs, NormalMap, testing::ValuesIn(uv_cases),
                         [](const auto& instance) { return instance.param.name; });

// Stretch and skew: only `exact` matches the displaced surface.
TEST(ExactFrame, KeepsStretchAndSkew) {
    const dmat2 stretch(1.6, 0.2, 0.5, 0.7);
    Material m;
    m.output("normal", m.resolve(m.from_tangent_normal(
                           m.texel_normal(), m.frame(m.uv0(), WR_FRAME_exact, WR_SCALE_surface))));
    const Expanded material(m);
    expect_displaced(material, 0, plane_with(stretch), dmat2(1), 1e-4);
    expect_displaced(material, 0, cylinder_with(mirror_u * stretch), dmat2(1), 1e-4);
}

// A light that leaves a slope dark leaves it dark on the mirrored half: the two halves of a
// symmetric model are mirror images.
TEST(MirroredUvs, KeepTheLightDirection) {
    const Surface left = plane_with(dmat2(1)), right = plane_with(mirror_u);
    for (const uint32_t method : {WR_FRAME_vertex, WR_FRAME_derived}) {
        Material m;
        m.output("normal", m.resolve(m.from_tangent_normal(
                               m.texel_normal(), m.frame(m.uv0(), method, WR_SCALE_unit))));
        const Expanded material(m);
        for (const Sample& sample : samples(30, 6)) {
            const dvec3 texel_value = map_normal(sample.st);
            Surroundings a = point_at(left, sample.st, sample.pixel);
            const dvec2 mirrored(-sample.st.x, sample.st.y);
            Surroundings b = point_at(right, mirrored, mirror_u * sample.pixel);
            set(a, texel, {texel_value.x, texel_value.y, texel_value.z, 1});
            set(b, texel, {texel_value.x, texel_value.y, texel_value.z, 1});
            const dvec3 axis = along(left.position, sample.st, dvec2(1, 0), 1e-3);
            const dvec3 seen = material.vector(0, b);
            const dvec3 reflected = seen - axis * (2 * glm::dot(axis, seen));
            EXPECT_LE(angle_deg(material.vector(0, a), reflected), 1e-6);
        }
    }
}

TEST(Tiling, LeavesUnitSlopesAndSteepensSurfaceSlopes) {
    const double tiles = 8;
    for (const Surface& surface : {plane_with(dmat2(1)), cylinder_with(rotation(0.3))}) {
        Material m;
        const Value tiled = m.uv0() * tiles;
        const auto unit = [&](Value uv, uint32_t method) {
            return m.vector_of(
                m.from_tangent_normal(m.texel_normal(), m.frame(uv, method, WR_SCALE_unit)));
        };
        const auto exact = [&](Value uv) {
            return m.vector_of(m.from_tangent_normal(
                m.texel_normal(), m.frame(uv, WR_FRAME_exact, WR_SCALE_surface)));
        };
        for (const uint32_t method : {WR_FRAME_vertex, WR_FRAME_derived}) {
            m.output("plain", unit(m.uv0(), method));
            m.output("tiled", unit(tiled, method));
        }
        m.output("plain", exact(m.uv0()));
        m.output("tiled", exact(tiled));
        const Expanded material(m);
        for (const Sample& sample : samples(30, 2)) {
            Surroundings around = point_at(surface, sample.st, sample.pixel);
            set(around, texel, {0.2, -0.3, 0.9, 1});
            for (size_t pair = 0; pair < 3; ++pair) {
                const dvec3 plain = material.vector(pair * 2, around);
                const dvec3 repeated = material.vector(pair * 2 + 1, around);
                EXPECT_LE(glm::distance(plain * (pair == 2 ? tiles : 1), repeated), 1e-9);
            }
        }
    }
}

// A height that depends on a tiled uv, displaced: `surface` slopes are physical.
TEST(Tiling, OfAHeightIsPhysical) {
    Material m;
    const Value uv = m.uv0() * 8;
    const Value height = m.sin(uv.x()) * m.sin(uv.y() * 2) * 0.02;
    m.output("normal", m.resolve(m.from_height(height)));
    m.output("height", height);
    const Expanded material(m);
    const Surface surface = plane_with(rotation(0.5));
    for (const Sample& sample : samples(30, 12)) {
        const auto h = [&](dvec2 st) { return material.number(1, values_at(surface, st)); };
        EXPECT_LE(angle_deg(material.vector(0, point_at(surface, sample.st, sample.pixel)),
                            displaced_normal(surface, h, sample.st)),
                  1e-5);
    }
}

// A guessed frame is a guess at the tangent of the same surface: it is exact if the direction is
// dP/du.
TEST(GuessedFrame, FollowsItsDirection) {
    const Surface surface = plane_with(dmat2(1));
    const dvec3 u = along(surface.position, dvec2(0), dvec2(1, 0), 1e-3);
    Material m;
    const Value off_the_plane = m.vector(u * 3.0 + surface.normal(dvec2(0)) * 0.7);
    m.output("normal", m.resolve(m.from_tangent_normal(m.texel_normal(),
                                                       m.guess_frame(m.uv0(), off_the_plane))));
    expect_displaced(Expanded(m), 0, surface, dmat2(1), 1e-4);
}

// n -> -n, as seen from the other side: a height's gradient and a derived frame are unchanged.
TEST(TurnedNormal, LeavesGradientsOfHeightsAndDerivedFrames) {
    Material m;
    const Value h = m.sin(m.position().x() * 4) * m.cos(m.uv1().y() * 3) * 0.1;
    const Value slope = m.vector(dvec2(0.3, -0.2));
    m.output("height", m.vector_of(m.from_height(h)));
    m.output("volume", m.vector_of(m.from_volume(m.position())));
    m.output("derived",
             m.vector_of(m.from_slope(slope, m.frame(m.uv1(), WR_FRAME_derived, WR_SCALE_unit))));
    m.output("exact",
             m.vector_of(m.from_slope(slope, m.frame(m.uv0(), WR_FRAME_exact, WR_SCALE_surface))));
    m.output("turned normal", m.vector_of(m.from_normal(m.vector(dvec3(0.3, 0.5, 0.6)))));
    const Expanded material(m);
    for (const Sample& sample : samples(40, 31)) {
        const Surroundings around = point_at(torus(), sample.st, sample.pixel);
        Surroundings turned = around;
        const dvec3 n = torus().normal(sample.st);
        set(turned, SurfaceInput::normal_, {-n.x, -n.y, -n.z});
        for (size_t output = 0; output < 5; ++output)
            EXPECT_LE(
                glm::distance(material.vector(output, around), material.vector(output, turned)),
                1e-12)
                << material.module().outputs[output].name;
    }
}

}  // namespace
}  // namespace wrinkle::test

// Tests on a bent cylinder: the uvs are unchanged, and a vertex shader transforms positions by a
// bend B, tangents by its Jacobian DB and normals by cof(DB). Heights and exact slopes must give
// the normal of the bent surface after displacement; a `unit` slope must give the same normal in
// the local uv axes as before the bend.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/mat3x3.hpp>

#include "property/in_float.h"

namespace wrinkle::test {
namespace {

// The axis of the straight cylinder is z; it is bent to a circle of radius 4 about (4, y, 0).
dvec3 bend(dvec3 p) {
    const double reach = 4 - p.x, angle = p.z / 4;
    return {4 - reach * std::cos(angle), p.y, reach * std::sin(angle)};
}

// Returns DB(from) * vector.
dvec3 moved(dvec3 from, dvec3 vector) {
    const auto line = [&](dvec2 t) { return bend(from + vector * t.x); };
    return along(line, dvec2(0), dvec2(1, 0), 1e-3);
}

// Returns the unit normal at B(from), from the cross product of two moved tangents; the outward
// side remains outward.
dvec3 moved_normal(dvec3 from, dvec3 n) {
    const dvec3 a = glm::normalize(glm::cross(n, dvec3(0.3, 0.4, 0.87))), b = glm::cross(n, a);
    return glm::normalize(glm::cross(moved(from, a), moved(from, b)));
}

Surface bent(const Surface& straight) {
    Surface surface = straight;
    surface.name = "bent cylinder";
    surface.position = [=](dvec2 st) { return bend(straight.position(st)); };
    surface.normal = [=](dvec2 st) {
        return moved_normal(straight.position(st), straight.normal(st));
    };
    return surface;
}

// As after skinning: the tangent is that of the straight cylinder, moved and normalised, with the
// same sign.
Surroundings skinned_point(const Surface& straight, const Surface& surface, const Sample& sample) {
    Surroundings around = point_at(surface, sample.st, sample.pixel);
    const uint32_t key = input_extra(SurfaceInput::tangent_, Variant::value);
    const Lanes rest = values_at(straight, sample.st).inputs.at(key);
    const dvec3 t = glm::normalize(moved(straight.position(sample.st), to_vec3(rest)));
    set(around, SurfaceInput::tangent_, {t.x, t.y, t.z, rest[3]});
    return around;
}

const dmat2 uv0_of_length(0.8, 0.3, -0.4, 0.9);

TEST(BentCylinder, KeepsHeightsAsTheDisplacedOne) {
    Material m;
    const Value u = m.uv0().x() * 60, v = m.uv0().y() * 45;
    const Value by_height = m.sin(u) * m.cos(v) * 0.002, second = m.sin(m.uv1().x() * 50) * 0.001;
    const Value slope = vec2(m.cos(u) * m.cos(v) * 60, m.sin(u) * m.sin(v) * -45) * 0.002;
    const Value exact = m.frame(m.uv0(), WR_FRAME_exact, WR_SCALE_surface);
    m.output("heights", m.resolve(m.from_height(by_height + second)));
    m.output("layers", m.resolve(m.add(m.from_slope(slope, exact), m.from_height(second))));
    m.output("height", by_height + second);
    const Expanded material(m);
    const Surface straight = cylinder_with(uv0_of_length), surface = bent(straight);
    for (const Sample& sample : samples(150, 23)) {
        const auto height = [&](dvec2 st) { return material.number(2, values_at(straight, st)); };
        const dvec3 truth = displaced_normal(surface, height, sample.st);
        const Surroundings around = skinned_point(straight, surface, sample);
        EXPECT_LE(angle_deg(material.vector(0, around), truth), 0.2);
        EXPECT_LE(angle_deg(material.vector(1, around), truth), 0.2);
        EXPECT_GT(angle_deg(displaced_normal(straight, height, sample.st), truth), 0)
            << "not bent at all";
    }
}

// Returns the components of a normal along increasing u, along cross(surface normal, u), and along
// the surface normal.
dvec3 in_local_axes(const Surface& surface, dvec2 st, dvec3 normal) {
    const dmat2 uv_of_st(along(surface.uv0, st, dvec2(1, 0), 1e-3),
                         along(surface.uv0, st, dvec2(0, 1), 1e-3));
    const dvec2 ahead = glm::inverse(uv_of_st)[0];
    const dvec3 u = glm::normalize(along(surface.position, st, ahead / glm::length(ahead), 1e-3));
    const dvec3 n = surface.normal(st);
    return {glm::dot(normal, u), glm::dot(normal, glm::cross(n, u)), glm::dot(normal, n)};
}

TEST(BentCylinder, KeepsUnitSlopesInTheirUv) {
    Material m;
    const Value texel = m.vector(dvec3(0.4, -0.25, 0.8));
    for (const uint32_t method : {WR_FRAME_vertex, WR_FRAME_derived})
        m.output("map",
                 m.resolve(m.from_tangent_normal(texel, m.frame(m.uv0(), method, WR_SCALE_unit))));
    const Expanded material(m);
    for (const dmat2& uv : {uv0_of_length, dmat2(-1, 0, 0.2, 1)}) {
        const Surface straight = cylinder_with(uv), surface = bent(straight);
        for (const Sample& sample : samples(80, 29)) {
            const Surroundings before = point_at(straight, sample.st, sample.pixel);
            const Surroundings after = skinned_point(straight, surface, sample);
            for (size_t output = 0; output < 2; ++output) {
                const dvec3 rest =
                    in_local_axes(straight, sample.st, material.vector(output, before));
                const dvec3 posed =
                    in_local_axes(surface, sample.st, material.vector(output, after));
                EXPECT_LE(angle_deg(rest, posed), 1e-4) << output;
                EXPECT_GT(angle_deg(rest, dvec3(0, 0, 1)), 20);
            }
        }
    }
}

}  // namespace
}  // namespace wrinkle::test

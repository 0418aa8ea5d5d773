// Tests of common pitfalls of bump mapping, one test each; see docs/pitfalls.md. These concern
// frames, uvs, normals and the screen; maps are in tests/nodes/pitfalls_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gpu/object_space.h"
#include "property/in_float.h"

namespace wrinkle::test {
namespace {

Value map_in(Material& m, Value uv, uint32_t method) {
    const uint32_t scale = method == WR_FRAME_exact ? WR_SCALE_surface : WR_SCALE_unit;
    return m.from_tangent_normal(m.texel_normal(), m.frame(uv, method, scale));
}

// On both sides of a mirrored seam the map gives the same bump along the seam. The rasteriser's N
// and T are shorter than 1 and not orthogonal; normalising them tilts each side differently.
TEST(Pitfalls, Pitfall01NormalisedTangentsMakeSeams) {
    Material m;
    m.output("normal", m.resolve(map_in(m, m.uv0(), WR_FRAME_vertex)));
    const Expanded material(m);
    const dvec3 n(0.1, 0.2, 0.8), t(0.7, 0.15, 0.1);
    Surroundings around = point_at(tilted_plane(), dvec2(0), dmat2(0.01));
    set3(around, SurfaceInput::normal_, n);
    const auto at = [&](dvec3 tangent, double w, dvec3 map) {
        set(around, SurfaceInput::tangent_, {tangent.x, tangent.y, tangent.z, w});
        set(around, texel, {map.x, map.y, map.z, 1});
        return material.vector(0, around);
    };
    const dvec3 left = at(t, 1, {0.3, 0.4, 0.8}), right = at(-t, -1, {-0.3, 0.4, 0.8});
    EXPECT_LE(angle_deg(left, right), 1e-9);
    const dvec3 baked = t * 0.3 + glm::cross(n, t) * 0.4 + n * 0.8;
    EXPECT_LE(angle_deg(left, baked), 1e-6);
    const dvec3 tidy_n = glm::normalize(n), tidy_t = glm::normalize(t);
    const dvec3 tidy = tidy_t * 0.3 + glm::cross(tidy_n, tidy_t) * 0.4 + tidy_n * 0.8;
    EXPECT_GT(angle_deg(tidy, baked), 1) << "the trap is no trap here";
}

// A bump tilted towards +x in space is so on either half of a model with mirrored uvs.
TEST(Pitfalls, Pitfall02MirroredUvs) {
    for (const dmat2 mirror : {dmat2(-1, 0, 0, 1), dmat2(1, 0, 0, -1)})
        for (const uint32_t method : {WR_FRAME_vertex, WR_FRAME_derived, WR_FRAME_exact}) {
            Material m;
            m.output("normal", m.resolve(map_in(m, m.uv0(), method)));
            const Expanded material(m);
            for (const Sample& sample : samples(20, 71)) {
                const dvec3 map(-0.3, 0.2, 0.9);  // dh/du = 1/3, dh/dv = -2/9
                Surroundings plain = point_at(plane_with(dmat2(1)), sample.st, sample.pixel);
                Surroundings mirrored = point_at(plane_with(mirror), sample.st, sample.pixel);
                const dvec2 lean = mirror * dvec2(map.x, map.y);
                set(plain, texel, {map.x, map.y, map.z, 1});
                set(mirrored, texel, {lean.x, lean.y, map.z, 1});
                EXPECT_LE(angle_deg(material.vector(0, plain), material.vector(0, mirrored)), 1e-6);
            }
        }
}

TEST(Pitfalls, Pitfall03CollapsedUvsGiveNoHoles) {
    Material m;
    for (const uint32_t method : {WR_FRAME_derived, WR_FRAME_exact})
        m.output("map", m.resolve(map_in(m, m.uv0(), method)));
    m.output("height", m.resolve(m.from_height(m.sin(m.uv0().x() * 9) * 0.1)));
    const InFloat material{Expanded(m)};
    for (const double size : {0.0, 1e-30, 1e-12, 1e-7})
        for (const double area : {0.0, 1.0}) {
            Surroundings around = point_at(sphere(), dvec2(0.4, 0.3), dmat2(1e-3));
            set(around, texel, {0.5, 0.3, 0.6, 1});
            set(around, SurfaceInput::uv0_, {size, size}, Variant::dx);
            set(around, SurfaceInput::uv0_, {size, size * (1 - area)}, Variant::dy);
            for (size_t output = 0; output < 3; ++output) {
                const dvec3 got = material.vector(output, around);
                EXPECT_NEAR(glm::length(got), 1, 1e-5) << size << " " << area;
                EXPECT_GT(glm::dot(got, normal_of(around)), 0);
            }
        }
}

// Invalid data of an unused uv set has no effect; a uv set with zero differentials gives a flat
// bump.
TEST(Pitfalls, Pitfall04RubbishInAnUnusedUvSet) {
    Material m;
    m.output("uv0", m.resolve(map_in(m, m.uv0(), WR_FRAME_auto)));
    m.output("uv1", m.resolve(m.add(map_in(m, m.uv0(), WR_FRAME_vertex),
                                    map_in(m, m.uv1(), WR_FRAME_derived))));
    const Expanded material(m);
    Surroundings around = point_at(torus(), dvec2(0.4, 0.3), dmat2(1e-3));
    set(around, texel, {0.5, 0.3, 0.6, 1});
    const dvec3 expected = material.vector(0, around);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double rubbish : {nan, 0.0}) {
        for (const Variant variant : {Variant::value, Variant::dx, Variant::dy})
            set(around, SurfaceInput::uv1_, {rubbish, rubbish}, variant);
        EXPECT_EQ(material.vector(0, around), expected);
    }
    EXPECT_LE(glm::distance(material.vector(1, around), expected), 1e-12);
}

TEST(Pitfalls, Pitfall05TangentsBelongToTheFirstUvSet) {
    Material wrong;
    wrong.output("normal", wrong.resolve(map_in(wrong, wrong.uv1(), WR_FRAME_vertex)));
    const Module refused = expand(wrong.module, {});
    ASSERT_EQ(refused.problems.size(), 1U);
    EXPECT_NE(refused.problems[0].message.find("uv0"), std::string::npos);
    // By default, the second set has a separate frame, independent of uv0 and its tangents.
    Material m;
    m.output("normal", m.resolve(map_in(m, m.uv1(), WR_FRAME_auto)));
    const Expanded material(m);
    for (const Sample& sample : samples(40, 72)) {
        Surroundings around = point_at(torus(), sample.st, sample.pixel);
        set(around, texel, {0.5, 0.3, 0.6, 1});
        const dvec3 seen = material.vector(0, around);
        set(around, SurfaceInput::tangent_, {0.3, 0.5, -0.2, -1});
        set(around, SurfaceInput::uv0_, {0.01, 0.7}, Variant::dx);
        EXPECT_EQ(material.vector(0, around), seen);
    }
}

// Triangles of a coarse mesh tilt to both sides of the smooth normal; their facets must not affect
// the tangent plane.
TEST(Pitfalls, Pitfall06FacetsDoNotShowInADerivedFrame) {
    Material m;
    for (const uint32_t method : {WR_FRAME_derived, WR_FRAME_exact})
        m.output("normal", m.resolve(map_in(m, m.uv0(), method)));
    const Expanded material(m);
    Surroundings around;
    set(around, SurfaceInput::normal_, {0, 0, 1});
    set(around, SurfaceInput::facing_, {1});
    set(around, SurfaceInput::uv0_, {0.01, 0}, Variant::dx);
    set(around, SurfaceInput::uv0_, {0, 0.01}, Variant::dy);
    set(around, texel, {0.5, 0.3, 0.6, 1});
    std::array<dvec3, 2> first{};
    for (const dvec2 lean : {dvec2(0), dvec2(0.4, 0), dvec2(-0.4, 0.1), dvec2(0.2, -0.3)}) {
        set3(around, SurfaceInput::position_, dvec3(0.01, 0, 0.01 * lean.x), Variant::dx);
        set3(around, SurfaceInput::position_, dvec3(0, 0.01, 0.01 * lean.y), Variant::dy);
        for (size_t output = 0; output < 2; ++output) {
            const dvec3 got = material.vector(output, around);
            if (lean == dvec2(0)) first[output] = got;
            EXPECT_LE(angle_deg(got, first[output]), 1e-6);
        }
    }
}

// MikkTSpace's tangent for a face without area. Meshes loaded by Wrinkle get a different tangent;
// an engine's own stream may contain it. At -0.5 the bump cancels the normal, and +z remains.
TEST(Pitfalls, Pitfall07TangentsAlongTheNormalStayFinite) {
    Material m;
    m.output("normal", m.resolve(map_in(m, m.uv0(), WR_FRAME_vertex)));
    const Expanded material(m);
    const InFloat in_float(material);
    Surroundings around = point_at(sphere(), dvec2(0.4, 0.3), dmat2(1e-3));
    const dvec3 n = normal_of(around);
    set(around, SurfaceInput::tangent_, {n.x, n.y, n.z, 1});
    for (const double lean : {-0.45, -0.2, 0.0, 0.5, 1.0}) {
        set(around, texel, {lean, 0.3, 0.5, 1});
        for (const dvec3 got : {material.vector(0, around), in_float.vector(0, around)})
            EXPECT_LE(angle_deg(got, n), 1e-3) << lean;
    }
    set(around, texel, {-0.5, 0.3, 0.5, 1});
    for (const dvec3 got : {material.vector(0, around), in_float.vector(0, around)})
        EXPECT_LE(angle_deg(got, dvec3(0, 0, 1)), 1e-3);
}

// A mirrored, non-uniformly scaled object: the bumped plane moves with its points, and the outward
// side stays outward.
TEST(Pitfalls, Pitfall08NegativeAndUnevenScale) {
    Material m;
    m.output("normal", m.resolve(m.from_height(m.sin(m.position().x() * 9) * 0.05)));
    const Expanded material(m);
    for (const glm::vec3 size : {glm::vec3(-1, 1, 1), glm::vec3(2, -0.5F, 1), glm::vec3(-3)}) {
        glm::mat4 object(1);
        for (int i = 0; i < 3; ++i)
            object[i][i] = size[i];
        const auto space =
            gpu::object_space(object, gpu::OrbitCamera{}, Bounds{glm::vec3(-1), glm::vec3(1)}, 1);
        ASSERT_TRUE(space);
        for (const Sample& sample : samples(20, 73)) {
            const dvec3 n = material.vector(0, point_at(torus(), sample.st, sample.pixel));
            // For a plane scaled along the axes, the normal scales by the reciprocals.
            const dvec3 expected = n / dvec3(size);
            EXPECT_LE(angle_deg(glm::dmat3(space->normal_to_world) * n, expected), 1e-3);
        }
    }
}

// Seen from behind, a solid's bump is outward and a sheet's is a dent: turned once, not twice.
TEST(Pitfalls, Pitfall09BackFacesTurnOnce) {
    for (const auto& [rule, behind] :
         {std::pair{BackFaces::mirror, 1.0}, {BackFaces::flip, -1.0}}) {
        Material m;
        const Value height = m.sin(m.position().x() * 90) * 0.002;
        m.output("normal", m.resolve(m.from_height(height)));
        m.output("height", height);
        const Expanded material(m, {true, rule});
        Surface inside = plane_with(dmat2(1));
        inside.normal = [](dvec2) { return -plane_with(dmat2(1)).normal(dvec2(0)); };
        for (const Sample& sample : samples(20, 74)) {
            Surroundings around = point_at(plane_with(dmat2(1)), sample.st, sample.pixel);
            set(around, SurfaceInput::facing_, {-1});
            const auto seen = [&, sign = behind](dvec2 st) {
                return sign * material.number(1, values_at(plane_with(dmat2(1)), st));
            };
            const dvec3 truth = displaced_normal(inside, seen, sample.st);
            EXPECT_LE(angle_deg(material.vector(0, around), truth), 1e-4);
        }
    }
}

// With a ramp, a power and a mask between the height and its bump, the bump is that of the final
// height.
TEST(Pitfalls, Pitfall12AnythingMayStandBetweenHeightAndBump) {
    Material m;
    const Value wave = m.sin(m.uv0().x() * 9) * m.cos(m.uv1().y() * 7) * 0.5 + m.number(0.5);
    const Value ramp = m.smoothstep(0.1, 0.8, wave) * op(Op::pow_, wave, m.number(1.7));
    const Value height = m.mix(ramp, wave, m.smoothstep(-1, 1, m.position().x())) * 0.05;
    m.output("normal", m.resolve(m.from_height(height)));
    m.output("height", height);
    const Expanded material(m);
    for (const Sample& sample : samples(100, 75)) {
        const auto h = [&](dvec2 st) { return material.number(1, values_at(tilted_plane(), st)); };
        const dvec3 truth = displaced_normal(tilted_plane(), h, sample.st);
        const Surroundings around = point_at(tilted_plane(), sample.st, sample.pixel);
        EXPECT_LE(angle_deg(material.vector(0, around), truth), 1e-4);
    }
}

// Screens with y up or down, any view, pixels of any shape: the bump is the same, not inverted.
TEST(Pitfalls, Pitfall13TheScreensAxesDoNotInvertABump) {
    Material m;
    m.output("height", m.resolve(m.from_height(m.sin(m.uv1().x() * 9) * 0.05)));
    m.output("map", m.resolve(map_in(m, m.uv1(), WR_FRAME_derived)));
    const Expanded material(m);
    for (const Sample& sample : samples(30, 76)) {
        const dmat2& p = sample.pixel;
        for (const dmat2 pixel : {dmat2(p[0], -p[1]), dmat2(-p[0], p[1]), -p, dmat2(p[1], p[0])})
            for (size_t output = 0; output < 2; ++output) {
                Surroundings a = point_at(torus(), sample.st, p);
                Surroundings b = point_at(torus(), sample.st, pixel);
                set(a, texel, {0.5, 0.3, 0.6, 1});
                set(b, texel, {0.5, 0.3, 0.6, 1});
                EXPECT_LE(angle_deg(material.vector(output, a), material.vector(output, b)), 1e-6);
            }
    }
}

// A ray tracer has no neighbouring pixels: any two directions on the surface serve as
// differentials.
TEST(Pitfalls, Pitfall28WithoutScreenDerivatives) {
    Material m;
    const Value height = m.sin(m.position().x() * 9) * m.cos(m.uv1().y() * 5) * 0.05;
    m.output("normal", m.resolve(m.from_height(height)));
    m.output("height", height);
    const Expanded material(m);
    for (const Sample& sample : samples(40, 77)) {
        const auto h = [&](dvec2 st) { return material.number(1, values_at(tilted_plane(), st)); };
        const dvec3 truth = displaced_normal(tilted_plane(), h, sample.st);
        for (const dmat2 differentials : {dmat2(1), dmat2(0.3, 2, -1, 0.1), dmat2(0, 1e-4, 1e3, 0)})
            EXPECT_LE(
                angle_deg(material.vector(0, point_at(tilted_plane(), sample.st, differentials)),
                          truth),
                1e-4);
    }
}

}  // namespace
}  // namespace wrinkle::test

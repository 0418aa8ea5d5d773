// Tests of properties, continued: T5 object-space normals, T7 the meaning of a scale, T9 matrices,
// T11 bumps on a resolved base, T12 differentials of a ray, T14 ten kilometres from the origin.
#include <gtest/gtest.h>

#include <cmath>

#include "gpu/object_space.h"
#include "property/in_float.h"

namespace wrinkle::test {
namespace {

// Any direction, inward as often as outward.
dvec3 direction(const Sample& sample) {
    return {std::sin(sample.st.x * 13), std::cos(sample.st.y * 17), std::sin(sample.st.y * 5 + 1)};
}

TEST(Reference, T5_AnObjectSpaceNormalIsReachedOrItsMirrorImage) {
    Material m;
    m.output("toward", m.resolve(m.from_normal(m.input(free_vector).xyz())));
    const Expanded material(m);
    int inward = 0;
    for (const Sample& sample : samples(300, 61)) {
        Surroundings around = point_at(torus(), sample.st, sample.pixel);
        const dvec3 n = normal_of(around), v = direction(sample);
        const double across = glm::dot(n, v);
        if (std::abs(across) < 1e-3) continue;
        const dvec3 mirrored = v - n * (2 * across);
        for (const double length : {1e-3, 1.0, 300.0}) {
            set_free(around, v * length);
            EXPECT_LE(angle_deg(material.vector(0, around), across < 0 ? mirrored : v), 1e-5);
        }
        inward += across < 0 ? 1 : 0;
    }
    EXPECT_GT(inward, 50);
}

// A normal in the tangent plane cannot be reached by a bump: the steepest finite bump is used, in
// both precisions.
TEST(Reference, T5_AnObjectSpaceNormalAcrossTheSurfaceIsFinite) {
    Material m;
    m.output("normal", m.resolve(m.from_normal(m.input(free_vector).xyz())));
    const Expanded material(m);
    const InFloat in_float(material);
    for (const Sample& sample : samples(50, 62)) {
        Surroundings around = point_at(sphere(), sample.st, sample.pixel);
        const dvec3 n = normal_of(around);
        const dvec3 v = glm::normalize(glm::cross(n, dvec3(0.3, 0.5, 0.8)));
        set_free(around, v);
        for (const dvec3 got : {material.vector(0, around), in_float.vector(0, around)}) {
            EXPECT_NEAR(glm::length(got), 1, 1e-6);
            EXPECT_LE(angle_deg(got, v), 0.01);
        }
    }
}

TEST(Reference, T5_StrengthScalesTheSlopeOfAnObjectSpaceNormal) {
    for (const double strength : {0.0, 0.25, 1.0, 2.0}) {
        Material m;
        m.output("normal", m.resolve(m.scale(m.from_normal(m.input(free_vector).xyz()), strength)));
        const Expanded material(m);
        for (const Sample& sample : samples(60, 63)) {
            Surroundings around = point_at(sphere(), sample.st, sample.pixel);
            const dvec3 n = normal_of(around), v = n + direction(sample) * 0.5;
            set_free(around, v);
            const double tilt = std::atan(strength * std::tan(angle_deg(v, n) / degrees));
            const dvec3 sideways = glm::normalize(v - n * glm::dot(v, n));
            const dvec3 expected = n * std::cos(tilt) + sideways * std::sin(tilt);
            EXPECT_LE(angle_deg(material.vector(0, around), expected), 1e-6);
        }
    }
}

// A matrix with rotation, unequal scales and, every second one, a mirror.
glm::mat4 any_matrix(int i) {
    const float a = 0.7F * static_cast<float>(i), flip = i % 2 ? -1.0F : 1.0F;
    const glm::vec3 x(std::cos(a), std::sin(a), 0.2F), y(-std::sin(a), 0.3F, std::cos(a));
    const glm::vec3 z = glm::cross(x, y);
    return {glm::vec4(x * (0.4F + 0.3F * static_cast<float>(i % 5)), 0), glm::vec4(y * 2.0F, 0),
            glm::vec4(z * flip * 0.6F, 0), glm::vec4(5, -4, 3, 1)};
}

// Two vectors in the plane of a bumped normal are transformed and crossed; the transformed normal
// gives the outward side. Uses no cofactor and no determinant.
void expect_moved_like_its_plane(const Value& bump, Material& m, double tolerance_deg) {
    m.output("normal", m.resolve(bump));
    const Expanded material(m);
    for (int i = 0; i < 20; ++i) {
        const glm::mat4 object = any_matrix(i);
        const auto space =
            gpu::object_space(object, gpu::OrbitCamera{}, Bounds{glm::vec3(-1), glm::vec3(1)}, 1);
        ASSERT_TRUE(space);
        const glm::dmat3 matrix(object), to_world(space->normal_to_world);
        for (const Sample& sample : samples(10, 64)) {
            Surroundings around = point_at(torus(), sample.st, sample.pixel);
            set_free(around, direction(sample));
            const dvec3 n = material.vector(0, around);
            const dvec3 a = glm::cross(n, dvec3(0.3, 0.5, -0.8)), b = glm::cross(n, a);
            dvec3 world = glm::cross(matrix * a, matrix * b);
            if (glm::dot(world, matrix * n) < 0) world = -world;
            EXPECT_LE(angle_deg(to_world * n, world), tolerance_deg);
        }
    }
}

TEST(Reference, T5_ObjectSpaceNormalsGoThroughNonUniformAndMirroredMatrices) {
    Material m;
    expect_moved_like_its_plane(m.from_normal(m.input(free_vector).xyz()), m, 1e-3);
}

TEST(Reference, T9_CofactorOfTheObjectsMatrixEqualsBruteForce) {
    Material m;
    const Value map = m.vector(dvec3(0.3, -0.5, 0.7));
    const Value a = m.from_height(m.sin(m.position().x() * 9) * m.cos(m.uv1().y() * 8) * 0.03);
    const Value b = m.from_tangent_normal(map, m.frame(m.uv0(), WR_FRAME_vertex, WR_SCALE_unit));
    expect_moved_like_its_plane(m.add(a, b), m, 1e-3);
}

// If uv is a length, all frames are equal.
TEST(Reference, T7_EqThreeEqualsTheTangentFrameOnAUnitSquare) {
    const Surface square = plane_with(dmat2(1));
    Material m;
    const Value slope = vec2(m.sin(m.uv0().x() * 5), m.cos(m.uv0().y() * 3)) * 0.4;
    m.output("exact",
             m.vector_of(m.from_slope(slope, m.frame(m.uv0(), WR_FRAME_exact, WR_SCALE_surface))));
    for (const uint32_t method : {WR_FRAME_vertex, WR_FRAME_derived})
        m.output("frame",
                 m.vector_of(m.from_slope(slope, m.frame(m.uv0(), method, WR_SCALE_unit))));
    const Expanded material(m);
    for (const Sample& sample : samples(50, 65)) {
        const Surroundings around = point_at(square, sample.st, sample.pixel);
        for (size_t output = 1; output < 3; ++output)
            EXPECT_LE(glm::distance(material.vector(0, around), material.vector(output, around)),
                      1e-6);
    }
}

// Tiled a times along u and b times along v, the same slopes per uv are a and b times as steep.
TEST(Reference, T7_AnisotropicTilingSteepensEachAxisByItsOwnRate) {
    const double a = 3, b = 0.5;
    const Surface plane = plane_with(dmat2(1));
    const dvec3 x = along(plane.position, dvec2(0), dvec2(1, 0), 1e-2);
    const dvec3 y = along(plane.position, dvec2(0), dvec2(0, 1), 1e-2);
    Material m;
    const Value tiled = m.uv0() * m.vector(dvec2(a, b)) + m.vector(dvec2(0.4, -0.9));
    m.output("exact",
             m.vector_of(m.from_tangent_normal(m.vector(dvec3(-0.3, 0.2, 0.5)),
                                               m.frame(tiled, WR_FRAME_exact, WR_SCALE_surface))));
    const Expanded material(m);
    for (const Sample& sample : samples(20, 66)) {
        const Surroundings around = point_at(plane, sample.st, sample.pixel);
        EXPECT_LE(glm::distance(material.vector(0, around), x * (0.6 * a) - y * (0.4 * b)), 1e-6);
    }
}

TEST(Reference, T7_AMeshOfTwiceTheSizeHasHalfTheSurfaceSlopeAndTheSameUnitSlope) {
    Surface large = torus();
    const auto position = large.position;
    large.position = [=](dvec2 st) { return position(st) * 2.0; };
    Material m;
    const Value slope = m.vector(dvec2(0.3, -0.2));
    m.output("surface", m.resolve(m.from_height(m.sin(m.uv1().x() * 5) * 0.1)));
    m.output("unit",
             m.resolve(m.from_slope(slope, m.frame(m.uv1(), WR_FRAME_derived, WR_SCALE_unit))));
    const Expanded material(m);
    const auto tangent_of = [](dvec3 normal, dvec3 n) {
        return std::tan(angle_deg(normal, n) / degrees);
    };
    for (const Sample& sample : samples(50, 67)) {
        const Surroundings before = point_at(torus(), sample.st, sample.pixel);
        const Surroundings after = point_at(large, sample.st, sample.pixel);
        const dvec3 n = normal_of(before);
        EXPECT_NEAR(tangent_of(material.vector(0, after), n),
                    tangent_of(material.vector(0, before), n) / 2, 1e-6);
        EXPECT_LE(angle_deg(material.vector(1, after), material.vector(1, before)), 1e-6);
    }
}

TEST(Reference, T11_OrderMattersOnlyAcrossAResolve) {
    Material m;
    const Value a = m.sin(m.position().x() * 6) * 0.1, b = m.cos(m.uv1().y() * 9) * 0.05;
    const auto on = [&](Value height, Value normal) {
        const Value base = op(Op::base_, normal);
        return m.resolve(
            {&m.module, m.module.add(Op::gradient_from_height_, {height.id}, base.id)});
    };
    m.output("a then b", on(b, m.resolve(m.from_height(a))));
    m.output("b then a", on(a, m.resolve(m.from_height(b))));
    m.output("a + b", m.resolve(m.add(m.from_height(a), m.from_height(b))));
    m.output("b + a", m.resolve(m.add(m.from_height(b), m.from_height(a))));
    const Expanded material(m);
    double across = 0;
    for (const Sample& sample : samples(60, 68)) {
        const Surroundings around = point_at(torus(), sample.st, sample.pixel);
        across =
            std::fmax(across, angle_deg(material.vector(0, around), material.vector(1, around)));
        EXPECT_LE(angle_deg(material.vector(2, around), material.vector(3, around)), 1e-6);
    }
    EXPECT_GT(across, 1);
}

// ds/dx = dP/dx . gradient(s), for any scalar s on a surface: converts a gradient to a screen
// derivative without hardware derivatives.
TEST(Reference, ScreenDerivativeIsTheGradientAlongThePixel) {
    Material m;
    const Value s = m.sin(m.position().x() * 3) + m.cos(m.uv1().y() * 4) * 0.5;
    m.output("gradient", m.vector_of(m.from_height(s)));
    m.output("scalar", s);
    const Expanded material(m);
    for (const Surface& surface : {sphere(), torus()})
        for (const Sample& sample : samples(60, 70)) {
            const Surroundings around = point_at(surface, sample.st, sample.pixel);
            const dvec3 gamma = material.vector(0, around);
            const auto scalar = [&](dvec2 st) {
                return material.number(1, values_at(surface, st));
            };
            for (const int axis : {0, 1}) {
                const dvec2 way = sample.pixel[axis];
                const double length = glm::length(way);
                const double change = along(scalar, sample.st, way / length, 1e-3);
                const dvec3 moved = along(surface.position, sample.st, way / length, 1e-3);
                EXPECT_NEAR(glm::dot(moved, gamma), change, 1e-6);
            }
        }
}

// Intersection of the ray of the pixel at offset (x, y) with the tangent plane; ray(0, 0) hits the
// surface.
struct PixelRays {
    dvec3 eye, toward, beside_x, beside_y;

    dvec3 ray(dvec2 pixel) const { return toward + beside_x * pixel.x + beside_y * pixel.y; }
    dvec3 hit(dvec3 n, dvec2 pixel) const {
        const dvec3 way = ray(pixel);
        return eye + way * (glm::dot(n, toward) / glm::dot(n, way));
    }
    // Differential by the quotient rule, as written by a caller without neighbouring pixels.
    dvec3 change(dvec3 n, dvec3 beside) const {
        return beside - toward * (glm::dot(n, beside) / glm::dot(n, toward));
    }
};

// Differentials computed only from the pixel's ray equal those of its neighbours' rays on the
// tangent plane, and give a material the same bump as any other pixel.
TEST(Reference, T12_DifferentialsOfAPixelsRayAreThoseOfItsNeighbours) {
    Material m;
    m.output("height", m.resolve(m.from_height(m.sin(m.position().x() * 3) * 0.1)));
    m.output("map", m.resolve(m.from_slope(m.vector(dvec2(0.4, -0.3)),
                                           m.frame(m.uv1(), WR_FRAME_derived, WR_SCALE_unit))));
    const Expanded material(m);
    for (const Sample& sample : samples(80, 81)) {
        const Surface surface = torus();
        Surroundings around = point_at(surface, sample.st, sample.pixel);
        const dvec3 n = normal_of(around), s = along(surface.position, sample.st, {1, 0}, 1e-3);
        const dvec3 side = glm::normalize(s), toward = side * 2.0 - n * (sample.st.y + 1.2);
        const PixelRays rays{surface.position(sample.st) - toward, toward,
                             glm::cross(side, n) * 1e-3 + n * 4e-4, side * 1e-3 - n * 2e-4};
        const dvec3 t = along(surface.position, sample.st, {0, 1}, 1e-3);
        const glm::dmat3 to_st = glm::inverse(glm::dmat3(s, t, n));
        for (const Variant axis : {Variant::dx, Variant::dy}) {
            const bool is_x = axis == Variant::dx;
            const dvec3 moved = rays.change(n, is_x ? rays.beside_x : rays.beside_y);
            const auto hit = [&](dvec2 pixel) { return rays.hit(n, pixel); };
            const dvec3 neighbours = along(hit, dvec2(0), is_x ? dvec2(1, 0) : dvec2(0, 1), 1e-2);
            EXPECT_LE(glm::distance(moved, neighbours), 1e-6 * glm::length(moved));
            const dvec3 st = to_st * moved;
            const dvec2 uv = along(surface.uv1, sample.st, {1, 0}, 1e-3) * st.x +
                             along(surface.uv1, sample.st, {0, 1}, 1e-3) * st.y;
            set(around, SurfaceInput::position_, {moved.x, moved.y, moved.z}, axis);
            set(around, SurfaceInput::uv1_, {uv.x, uv.y}, axis);
        }
        const Surroundings other = point_at(surface, sample.st, sample.pixel);
        for (size_t output = 0; output < 2; ++output)
            EXPECT_LE(angle_deg(material.vector(output, around), material.vector(output, other)),
                      1e-6);
    }
}

// The tangent nearest to a direction, by cross products and by Gram-Schmidt: the frames are equal.
TEST(Reference, AGuessedFrameIsThatOfBothMethods) {
    const dvec3 up(0, 1, 0);
    Material m;
    for (const dvec2 slope : {dvec2(1, 0), dvec2(0, 1)})
        m.output("axis", m.vector_of(m.from_slope(m.vector(slope),
                                                  m.guess_frame(m.uv0(), m.vector(up * 3.0)))));
    const Expanded material(m);
    for (const Sample& sample : samples(60, 80)) {
        const Surroundings around = point_at(torus(), sample.st, sample.pixel);
        const dvec3 n = normal_of(around), side = glm::normalize(glm::cross(n, up));
        EXPECT_LE(glm::distance(material.vector(0, around), glm::cross(side, n)), 1e-6);
        EXPECT_LE(glm::distance(material.vector(1, around), side), 1e-6);
        const dvec3 gram_schmidt = glm::normalize(up - n * glm::dot(n, up));
        EXPECT_LE(glm::distance(material.vector(0, around), gram_schmidt), 1e-6);
    }
}

// A mesh with coordinates ten kilometres away, where floats are a millimetre apart: differentials
// are those of the position relative to the eye, so the bump equals that of the same mesh at the
// origin.
TEST(Reference, T14_CoordinatesTenKilometresAwayKeepTheBump) {
    const dvec3 far(7000, -5000, 5099);
    Surface away = torus();
    const auto position = away.position;
    away.position = [=](dvec2 st) { return position(st) + far; };
    Material m;
    const Value slope = m.vector(dvec2(0.3, -0.2));
    m.output("height", m.resolve(m.from_height(m.sin(m.uv1().x() * 9) * 0.05)));
    m.output("exact",
             m.resolve(m.from_slope(slope, m.frame(m.uv0(), WR_FRAME_exact, WR_SCALE_surface))));
    m.output("derived",
             m.resolve(m.from_slope(slope, m.frame(m.uv1(), WR_FRAME_derived, WR_SCALE_unit))));
    const Expanded material(m);
    const InFloat in_float(material);
    for (const Sample& sample : samples(80, 69)) {
        const Surroundings near = point_at(torus(), sample.st, sample.pixel);
        Surroundings around = point_at(away, sample.st, sample.pixel);
        for (const Variant axis : {Variant::dx, Variant::dy}) {
            const uint32_t key = input_extra(SurfaceInput::position_, axis);
            for (size_t i = 0; i < 3; ++i) {
                const float seen = 0.5F * static_cast<float>(i + 1);
                const auto next = static_cast<float>(seen + near.inputs.at(key)[i]);
                around.inputs[key][i] = next - seen;
            }
        }
        for (size_t output = 0; output < 3; ++output)
            EXPECT_LE(angle_deg(in_float.vector(output, around), material.vector(output, near)),
                      0.05);
    }
}

}  // namespace
}  // namespace wrinkle::test

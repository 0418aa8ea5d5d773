// Tests of object matrices applied to a bumped normal, by brute force: two vectors in the bumped
// surface are transformed and crossed. Also compares scaling the mesh with scaling the object.
#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>

#include "gpu/object_space.h"
#include "property/material.h"

namespace wrinkle::test {
namespace {

struct MatrixCase {
    const char* name;
    glm::mat4 object;
};

glm::mat4 columns(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    return {glm::vec4(a, 0), glm::vec4(b, 0), glm::vec4(c, 0), glm::vec4(3, -2, 1, 1)};
}

const MatrixCase matrices[] = {
    {"identity", columns({1, 0, 0}, {0, 1, 0}, {0, 0, 1})},
    {"uniform", columns({2.5F, 0, 0}, {0, 2.5F, 0}, {0, 0, 2.5F})},
    {"stretched", columns({3, 0, 0}, {0, 0.5F, 0}, {0, 0, 1})},
    {"sheared", columns({1, 0.3F, 0}, {0.7F, 1, 0.2F}, {0, -0.4F, 1.5F})},
    {"mirrored", columns({-1, 0, 0}, {0, 1, 0}, {0, 0, 1})},
    {"mirrored_and_sheared", columns({1, 0.3F, 0.5F}, {0.2F, -1.4F, 0.1F}, {0.3F, 0, 0.8F})},
    {"inside_out", columns({-2, 0, 0}, {0, -1, 0}, {0, 0, -0.5F})},
    {"tiny", columns({1e-6F, 0, 0}, {0, 2e-6F, 1e-7F}, {0, 0, -3e-6F})},
};

class ObjectMatrix : public testing::TestWithParam<MatrixCase> {};

Value bump(Material& m) {
    return m.sin(m.position().x() * 9) * m.cos(m.uv1().y() * 8) * 0.03;
}

TEST_P(ObjectMatrix, TurnsTheBumpedNormalAsItTurnsTheBumpedSurface) {
    Material m;
    m.output("normal", m.resolve(m.from_height(bump(m))));
    const Expanded material(m);
    const auto space = gpu::object_space(GetParam().object, gpu::OrbitCamera{},
                                         Bounds{glm::vec3(-1), glm::vec3(1)}, 1);
    ASSERT_TRUE(space);
    const glm::dmat3 matrix(GetParam().object), to_world(space->normal_to_world);
    for (const Sample& sample : samples(50, 13)) {
        const dvec3 n = material.vector(0, point_at(torus(), sample.st, sample.pixel));
        const dvec3 a = glm::cross(n, dvec3(0.3, 0.5, -0.8)), b = glm::cross(n, a);
        dvec3 world = glm::cross(glm::normalize(matrix * a), glm::normalize(matrix * b));
        if (glm::dot(world, matrix * n) < 0) world = -world;  // the outward side stays outward
        EXPECT_LE(angle_deg(to_world * n, world), 1e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(Matrices, ObjectMatrix, testing::ValuesIn(matrices),
                         [](const auto& instance) { return instance.param.name; });

Surface resized(double size) {
    Surface surface = torus();
    const Surface original = surface;
    surface.radius *= size;
    surface.position = [=](dvec2 st) { return original.position(st) * size; };
    return surface;
}

// The mesh's coordinates grow, the heights do not: `surface` slopes shrink, `unit` slopes are
// unchanged.
TEST(MeshSize, ChangesSurfaceSlopesAlone) {
    Material m;
    const Value slope = m.vector(dvec2(0.3, -0.2));
    m.output("surface", m.vector_of(m.from_height(m.sin(m.uv0().x() * 5) * 0.1)));
    m.output("exact",
             m.vector_of(m.from_slope(slope, m.frame(m.uv1(), WR_FRAME_exact, WR_SCALE_surface))));
    m.output("vertex",
             m.vector_of(m.from_slope(slope, m.frame(m.uv0(), WR_FRAME_vertex, WR_SCALE_unit))));
    m.output("derived",
             m.vector_of(m.from_slope(slope, m.frame(m.uv1(), WR_FRAME_derived, WR_SCALE_unit))));
    const Expanded material(m);
    for (const double size : {0.01, 2.0, 1000.0}) {
        for (const Sample& sample : samples(20, 14)) {
            const Surroundings before = point_at(torus(), sample.st, sample.pixel);
            const Surroundings after = point_at(resized(size), sample.st, sample.pixel);
            for (size_t output = 0; output < 4; ++output) {
                const double factor = output < 2 ? 1 / size : 1;
                const dvec3 expected = material.vector(output, before) * factor;
                EXPECT_LE(glm::distance(material.vector(output, after), expected),
                          1e-9 * factor + 1e-12);
            }
        }
    }
}

}  // namespace
}  // namespace wrinkle::test

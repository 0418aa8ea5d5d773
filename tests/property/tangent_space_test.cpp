// Tests that a normal in tangent space is the texel of a tangent-space map: a texel that a graph
// reads in the frame of uv0 is the tangent-space normal of the bumped surface, for rotated,
// mirrored and stretched uvs.
#include "ir/tangent_space.h"

#include <gtest/gtest.h>

#include <cmath>

#include "property/material.h"

namespace wrinkle::test {
namespace {

const dmat2 uv0_of_lengths[] = {dmat2(1), dmat2(-1, 0, 0, 1), dmat2(0.6, 0.8, 0.8, -0.6),
                                dmat2(0, 1, -1, 0), dmat2(0.6, 0.8, -0.8, 0.6)};

TEST(TangentSpace, NormalsAreTheTexelsOfTheFrame) {
    for (const bool vertex_tangents : {true, false}) {
        Material m;
        const uint32_t method = vertex_tangents ? WR_FRAME_vertex : WR_FRAME_derived;
        m.module.outputs.push_back(
            {"normal", WR_PORT_normal,
             m.resolve(
                  m.from_tangent_normal(m.texel_normal(), m.frame(m.uv0(), method, WR_SCALE_unit)))
                 .id});
        const Module module = with_tangent_space_normals(Expanded(m).module(), vertex_tangents);
        for (const dmat2& uv0_of_length : uv0_of_lengths)
            for (const Surface& surface :
                 {plane_with(uv0_of_length), cylinder_with(uv0_of_length)}) {
                SCOPED_TRACE(std::string(surface.name) + (vertex_tangents ? "" : ", derived"));
                for (const Sample& sample : samples(40, 41)) {
                    const dvec3 texel_normal = glm::normalize(
                        dvec3(std::sin(9 * sample.st.x), std::cos(7 * sample.st.y), 0.8));
                    Surroundings around = point_at(surface, sample.st, sample.pixel);
                    set(around, texel, {texel_normal.x, texel_normal.y, texel_normal.z, 1});
                    const dvec3 found = to_vec3(interpret(module, module.outputs[0].value, around));
                    EXPECT_LE(angle_deg(found, texel_normal), 1e-6);
                }
            }
    }
}

// Vertex normals and tangents are interpolated, neither unit nor orthogonal.
TEST(TangentSpace, NormalsTimesTheInterpolatedFrameAreTheObjectsNormals) {
    Material m;
    m.module.outputs.push_back({"normal", WR_PORT_normal, normalize(m.texel_normal()).id});
    const Module object = Expanded(m).module();
    const Module tangent = with_tangent_space_normals(Module(object), true);
    for (const double w : {-1.0, 1.0}) {
        const dvec3 n(0.1, -0.2, 0.9), t(0.8, 0.3, 0.1), bumped(0.4, -0.3, 0.7);
        const dvec3 b = glm::cross(n, t) * w;
        Surroundings around;
        set3(around, SurfaceInput::normal_, n);
        set(around, SurfaceInput::tangent_, {t.x, t.y, t.z, w});
        set_free(around, bumped);
        const dvec3 found = to_vec3(interpret(tangent, tangent.outputs[0].value, around));
        EXPECT_LE(angle_deg(t * found.x + b * found.y + n * found.z, bumped), 1e-9);
    }
}

}  // namespace
}  // namespace wrinkle::test

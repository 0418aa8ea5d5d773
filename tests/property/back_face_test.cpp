// Tests of back faces by displacement: `mirror` shows a solid with outward bumps on both sides,
// `flip` the other side of one thin sheet, `none` the front's normal.
#include <gtest/gtest.h>

#include "property/material.h"

namespace wrinkle::test {
namespace {

struct BackFaceCase {
    const char* name;
    BackFaces rule;
    double bump_behind;  // along the normal that faces the viewer
    double turn;
};

constexpr BackFaceCase back_face_cases[] = {
    {"mirror", BackFaces::mirror, 1, -1},
    {"flip", BackFaces::flip, -1, -1},
    {"none", BackFaces::none, 1, 1},
};

class BackFace : public testing::TestWithParam<BackFaceCase> {};

// The sphere with its normals multiplied by `turn`: -1 for a viewer inside.
Surface seen_from_behind(double turn) {
    Surface surface = sphere();
    const Surface front = surface;
    surface.normal = [=](dvec2 st) { return front.normal(st) * turn; };
    return surface;
}

TEST_P(BackFace, ShowsTheDisplacedSurface) {
    Material m;
    const Value a = m.sin(m.position().x() * 150) * 0.001, b = m.cos(m.uv0().y() * 200) * 0.0005;
    const Value slope = vec2(m.number(0), m.sin(m.uv0().y() * 200) * (-0.0005 * 200));
    const Value exact = m.frame(m.uv0(), WR_FRAME_exact, WR_SCALE_surface);
    m.output("normal", m.resolve(m.add(m.from_height(a), m.from_slope(slope, exact))));
    m.output("height", a + b);
    const Expanded material(m, {true, GetParam().rule});
    const Surface behind = seen_from_behind(GetParam().turn);
    for (const Sample& sample : samples(50, 15)) {
        Surroundings around = point_at(sphere(), sample.st, sample.pixel);
        const auto height = [&](dvec2 st) { return material.number(1, values_at(sphere(), st)); };
        EXPECT_LE(
            angle_deg(material.vector(0, around), displaced_normal(sphere(), height, sample.st)),
            0.05);
        set(around, SurfaceInput::facing_, {-1});
        const auto height_behind = [&](dvec2 st) { return height(st) * GetParam().bump_behind; };
        EXPECT_LE(angle_deg(material.vector(0, around),
                            displaced_normal(behind, height_behind, sample.st)),
                  0.05);
    }
}

// The same rule applies to every kind of gradient, flat ones included.
TEST_P(BackFace, TurnsAllKindsOfGradientsAlike) {
    Material m;
    const Value tilt = m.vector(dvec3(0.3, -0.2, 0.8));
    const std::vector<Value> gradients{
        m.flat(),
        m.from_tangent_normal(tilt, m.frame(m.uv0(), WR_FRAME_vertex, WR_SCALE_unit)),
        m.from_tangent_normal(tilt, m.frame(m.uv1(), WR_FRAME_derived, WR_SCALE_unit)),
        m.from_volume(m.position()),
        m.from_normal(tilt),
        m.add(m.from_normal(tilt),
              m.from_tangent_normal(tilt, m.frame(m.uv0(), WR_FRAME_vertex, WR_SCALE_unit))),
    };
    for (const Value& gradient : gradients) {
        m.output("normal", m.resolve(gradient));
        m.output("gradient", m.vector_of(gradient));
    }
    const Expanded material(m, {true, GetParam().rule});
    for (const Sample& sample : samples(20, 16)) {
        Surroundings around = point_at(torus(), sample.st, sample.pixel);
        set(around, SurfaceInput::facing_, {-1});
        for (size_t i = 0; i < gradients.size(); ++i) {
            const dvec3 n = torus().normal(sample.st) * GetParam().turn;
            const dvec3 gamma = material.vector(2 * i + 1, around) * GetParam().bump_behind;
            EXPECT_LE(glm::distance(material.vector(2 * i, around), glm::normalize(n - gamma)),
                      1e-12)
                << "gradient " << i;
        }
    }
}

// A map's normal is outward or inward relative to the surface, independent of the visible side.
TEST_P(BackFace, AnOutwardNormalIsReversedOnlyWhereItPointsInward) {
    Material m;
    const Value map = m.vector(dvec3(0.3, -0.2, 0.8));
    m.output("toward", m.resolve(m.from_normal(map)));
    m.output("opposite", m.resolve(m.from_outward_normal(map)));
    m.output("opposite of it", m.resolve(m.from_outward_normal(-map)));
    const Expanded material(m, {true, GetParam().rule});
    int outward = 0;
    for (const Sample& sample : samples(40, 19)) {
        Surroundings around = point_at(sphere(), sample.st, sample.pixel);
        for (const double facing : {1.0, -1.0}) {
            set(around, SurfaceInput::facing_, {facing});
            EXPECT_LE(glm::distance(material.vector(1, around), material.vector(2, around)), 1e-12);
            if (glm::dot(sphere().normal(sample.st), dvec3(0.3, -0.2, 0.8)) <= 0.05) continue;
            ++outward;
            EXPECT_LE(glm::distance(material.vector(0, around), material.vector(1, around)), 1e-12);
        }
    }
    EXPECT_GE(outward, 10);
}

INSTANTIATE_TEST_SUITE_P(Rules, BackFace, testing::ValuesIn(back_face_cases),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace wrinkle::test

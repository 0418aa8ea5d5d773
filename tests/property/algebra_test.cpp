// Tests of layers: order, grouping, flat and opposite ones; and that the result depends on the
// surface, not on its parametrisation or the view.
#include <gtest/gtest.h>

#include <cmath>

#include "ir/rewrite.h"
#include "property/material.h"

namespace wrinkle::test {
namespace {

// One layer of each kind of source, on both uv sets and in several frames.
constexpr int layer_kinds = 7;
Value layer(Material& m, int kind) {
    const Value wave = m.sin(m.position().x() * 5) * m.cos(m.uv1().y() * 4);
    const Value tilt = m.vector(dvec3(0.3, -0.2, 0.8));
    const Value lean = m.sin(m.uv0().x() * 7) * 0.4;
    const Value m_normal = {
        &m.module, m.module.construct(Type::vec3_, {lean.id, m.number(0.2).id, m.number(0.9).id})};
    switch (kind) {
        case 0:
            return m.from_height(wave * 0.06);
        case 1:
            return m.from_tangent_normal(m_normal,
                                         m.frame(m.uv0(), WR_FRAME_vertex, WR_SCALE_unit));
        case 2:
            return m.from_tangent_normal(tilt, m.frame(m.uv1(), WR_FRAME_derived, WR_SCALE_unit));
        case 3:
            return m.from_slope(vec2(lean, wave * 0.1),
                                m.frame(m.uv1(), WR_FRAME_exact, WR_SCALE_surface));
        case 4:
            return m.from_volume(m.position() * m.position() * 0.1);
        case 5:
            return m.from_normal(m.input(SurfaceInput::normal_) + tilt * 0.3);
        default:
            return m.from_tangent_normal(
                m_normal, m.guess_frame(m.uv0(), m.vector(dvec3(0.2, 0.9, 0.3))), 1.7);
    }
}

// Compares the normals of several equivalent expressions at many points of every surface.
template <class Check>
void compare(Material& m, const std::vector<Value>& gradients, const Check& check) {
    for (const Value& gradient : gradients)
        m.output("normal", m.resolve(gradient));
    const Expanded material(m);
    for (const Surface& surface : {sphere(), torus(), tilted_plane()}) {
        for (const Sample& sample : samples(25, 11)) {
            const Surroundings around = point_at(surface, sample.st, sample.pixel);
            std::vector<dvec3> normals;
            for (size_t i = 0; i < gradients.size(); ++i)
                normals.push_back(material.vector(i, around));
            check(normals, around);
        }
    }
}

void expect_equal(const std::vector<dvec3>& normals, double tolerance) {
    for (size_t i = 0; i < normals.size(); ++i) {
        EXPECT_NEAR(glm::length(normals[i]), 1, 1e-12);
        EXPECT_LE(glm::distance(normals[0], normals[i]), tolerance) << "way " << i;
    }
}

TEST(Algebra, AddIsCommutativeAndAssociative) {
    for (int i = 0; i < layer_kinds; ++i) {
        SCOPED_TRACE(i);
        Material m;
        const Value a = layer(m, i), b = layer(m, (i + 1) % layer_kinds),
                    c = layer(m, (i + 3) % layer_kinds), d = layer(m, (i + 5) % layer_kinds);
        compare(m,
                {m.add(m.add(m.add(a, b), c), d), m.add(m.add(d, c), m.add(b, a)),
                 m.add(m.add(c, m.add(d, a)), b)},
                [](const auto& normals, const auto&) { expect_equal(normals, 1e-6); });
    }
}

TEST(Algebra, ScaleAndMixAreLinear) {
    for (int i = 0; i < layer_kinds; ++i) {
        SCOPED_TRACE(i);
        Material m;
        const Value a = layer(m, i), b = layer(m, (i + 2) % layer_kinds);
        compare(m,
                {m.add(m.scale(a, 0.75), m.scale(b, 0.25)), m.mix_gradients(a, b, 0.25),
                 m.scale(m.add(m.scale(a, 3), b), 0.25)},
                [](const auto& normals, const auto&) { expect_equal(normals, 1e-12); });
    }
}

TEST(Algebra, TheOrderOfManyLayersDoesNotMatter) {
    Material m;
    Value forward = layer(m, 0), backward = layer(m, layer_kinds - 1);
    for (int i = 1; i < layer_kinds; ++i) {
        forward = m.add(forward, layer(m, i));
        backward = m.add(backward, layer(m, layer_kinds - 1 - i));
    }
    compare(m, {forward, backward},
            [](const auto& normals, const auto&) { expect_equal(normals, 1e-12); });
}

TEST(Algebra, FlatLayersChangeNothing) {
    for (int i = 0; i < layer_kinds; ++i) {
        Material m;
        const Value a = layer(m, i);
        const Value flat_map =
            m.from_tangent_normal(m.vector(dvec3(0, 0, 1)), m.frame(m.uv0(), WR_FRAME_vertex, 1));
        const Value level = m.from_height(m.number(0.3));
        const Value itself = m.from_normal(m.input(SurfaceInput::normal_));
        compare(m,
                {a, m.add(a, m.flat()), m.add(flat_map, a), m.add(a, level), m.add(a, itself),
                 m.add(a, m.scale(layer(m, (i + 1) % layer_kinds), 0))},
                [](const auto& normals, const auto&) { expect_equal(normals, 1e-15); });
    }
}

TEST(Algebra, ALonelyFlatLayerIsTheSurface) {
    Material m;
    const Value flat_map =
        m.from_tangent_normal(m.vector(dvec3(0, 0, 0.7)), m.frame(m.uv0(), WR_FRAME_vertex, 1));
    compare(m, {m.flat(), flat_map, m.from_height(m.number(2)), m.scale(layer(m, 2), 0)},
            [](const auto& normals, const Surroundings& around) {
                const dvec3 n =
                    to_vec3(around.inputs.at(input_extra(SurfaceInput::normal_, Variant::value)));
                for (const dvec3& normal : normals)
                    EXPECT_LE(glm::distance(normal, n), 1e-15);
            });
}

TEST(Algebra, OppositeLayersCancelExactly) {
    for (int i = 0; i < layer_kinds; ++i) {
        SCOPED_TRACE(i);
        Material alone;
        const Value a = layer(alone, i);
        compare(alone, {alone.flat(), alone.add(a, alone.scale(a, -1))},
                [](const auto& normals, const auto&) { expect_equal(normals, 1e-15); });
        Material m;
        const Value c = layer(m, i), d = layer(m, (i + 1) % layer_kinds);
        compare(m, {d, m.add(m.add(c, d), m.scale(c, -1))},
                [](const auto& normals, const auto&) { expect_equal(normals, 1e-15); });
    }
}

TEST(Algebra, AVectorIsTangentAndGivesTheNormal) {
    for (int i = 0; i < layer_kinds; ++i) {
        Material m;
        const Value a = m.add(layer(m, i), layer(m, (i + 4) % layer_kinds));
        m.output("normal", m.resolve(a));
        m.output("gradient", m.vector_of(a));
        const Expanded material(m);
        for (const Sample& sample : samples(25, 3)) {
            const Surface surface = torus();
            const Surroundings around = point_at(surface, sample.st, sample.pixel);
            const dvec3 n = surface.normal(sample.st), gamma = material.vector(1, around);
            EXPECT_NEAR(glm::dot(n, gamma), 0, 1e-9);
            EXPECT_LE(glm::distance(glm::normalize(n - gamma), material.vector(0, around)), 1e-12);
        }
    }
}

// The same hills as functions of position and of two uv sets, with pixels of any shape.
TEST(Parametrisation, DoesNotMatter) {
    const Surface plane = plane_with(dmat2(2, 0.3, -0.5, 1.5));
    Material m;
    const dvec3 k = dvec3(0.8, 0.36, 0.48) * 5.0 + dvec3(-0.6, 0.48, 0.64) * 3.0;
    // The same wave vector in uv0, by solving for it rather than by transforming it.
    const dvec2 length(5, 3);
    const dmat2 a(2, 0.3, -0.5, 1.5);
    const dvec2 in_uv = glm::inverse(glm::transpose(a)) * length;
    const dvec2 shift = -dvec2(0.25, 0.5);
    const Value by_position =
        m.sin(dot(m.position() - m.vector(dvec3(1, 2, 3)), m.vector(k))) * 0.05;
    const Value by_uv = m.sin(dot(m.uv0() + m.vector(shift), m.vector(in_uv))) * 0.05;
    m.output("position", m.resolve(m.from_height(by_position)));
    m.output("uv", m.resolve(m.from_height(by_uv)));
    const Expanded material(m);
    for (const Sample& sample : samples(60, 21)) {
        const dvec3 expected = material.vector(0, point_at(plane, sample.st, dmat2(1e-3)));
        for (const dmat2& pixel :
             {sample.pixel, -sample.pixel, dmat2(sample.pixel[1], sample.pixel[0])}) {
            const Surroundings around = point_at(plane, sample.st, pixel);
            EXPECT_LE(glm::distance(material.vector(0, around), expected), 1e-9);
            EXPECT_LE(glm::distance(material.vector(1, around), expected), 1e-9);
        }
    }
}

TEST(Parametrisation, ThePixelDoesNotMatter) {
    for (int i = 0; i < layer_kinds; ++i) {
        SCOPED_TRACE(i);
        Material m;
        m.output("normal", m.resolve(m.add(layer(m, i), layer(m, 0))));
        const Expanded material(m);
        for (const Surface& surface : {sphere(), torus()}) {
            for (const Sample& sample : samples(20, 8)) {
                const dvec3 expected =
                    material.vector(0, point_at(surface, sample.st, dmat2(1e-3)));
                const dmat2& p = sample.pixel;
                for (const dmat2& pixel :
                     {p, -p, dmat2(p[1], p[0]), dmat2(p[0], p[1] + 4.0 * p[0])})
                    EXPECT_LE(glm::distance(material.vector(0, point_at(surface, sample.st, pixel)),
                                            expected),
                              1e-8);
            }
        }
    }
}

TEST(Parametrisation, SoDoesNotItsSize) {
    for (int i = 0; i < layer_kinds; ++i) {
        Material m;
        m.output("normal", m.resolve(m.add(layer(m, i), layer(m, 3))));
        const Expanded material(m);
        for (const Sample& sample : samples(10, 9)) {
            const dmat2 unit = sample.pixel / glm::length(sample.pixel[0]);
            const dvec3 expected = material.vector(0, point_at(torus(), sample.st, unit));
            for (const double size : {1e-3, 1e-6, 1e3}) {
                const Surroundings around = point_at(torus(), sample.st, unit * size);
                EXPECT_LE(glm::distance(material.vector(0, around), expected), 1e-9) << size;
            }
        }
    }
}

// Low-poly meshes: the interpolated normal differs from that of the triangle.
TEST(VolumeForm, EqualsTheHeightOfPosition) {
    Material m;
    const Value p = m.position();
    const Value height = m.sin(dot(p, m.vector(dvec3(3, -2, 1)))) * 0.1 + p.x() * p.y() * 0.2;
    const double step = 1e-4;
    std::array<Id, 3> gradient{};
    const dvec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (size_t axis = 0; axis < 3; ++axis) {
        const auto moved = [&](double by) {
            const Id from = m.position().id, to = (p + m.vector(axes[axis] * by)).id;
            return Value{&m.module,
                         substitute(m.module, height.id, std::span(&from, 1), std::span(&to, 1))};
        };
        gradient[axis] = ((moved(step) - moved(-step)) / m.number(2 * step)).id;
    }
    const Value volume{&m.module,
                       m.module.construct(Type::vec3_, {gradient[0], gradient[1], gradient[2]})};
    m.output("height", m.resolve(m.from_height(height)));
    m.output("volume", m.resolve(m.from_volume(volume)));
    const Expanded material(m);
    for (const Sample& sample : samples(100, 4)) {
        Surroundings around = point_at(sphere(), sample.st, sample.pixel);
        const dvec3 n = sphere().normal(sample.st) + dvec3(0.2, -0.1, 0.15);
        set(around, SurfaceInput::normal_, {n.x, n.y, n.z});
        EXPECT_LE(glm::distance(material.vector(0, around), material.vector(1, around)), 1e-7);
    }
}

}  // namespace
}  // namespace wrinkle::test

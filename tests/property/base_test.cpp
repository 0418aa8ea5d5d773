// Tests of bumps on a bumped base: a gradient is in the tangent plane of its base, cannot be added
// to one of another base, and a small bump on a resolved surface is that of the surface displaced
// twice.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "property/material.h"
#include "support/angle.h"
#include "support/files.h"

namespace wrinkle::test {
namespace {

struct Layered {
    Material m;
    Value first;  // resolved
    Value base;

    Layered() {
        m.module.nodes = {{}, {"dents"}, {"scratches"}, {"sum"}};
        m.module.current_node = 1;
        first = m.resolve(m.from_height(m.sin(m.position().x() * 6) * 0.05));
        base = op(Op::base_, first);
    }
    Value on_base(Op source, Value operand) {
        return {&m.module, m.module.add(source, {operand.id}, base.id)};
    }
};

TEST(Base, OfTwoGradientsMustAgree) {
    Layered layered;
    Material& m = layered.m;
    m.module.current_node = 2;
    const Value other = op(Op::base_, m.resolve(m.from_volume(m.position())));
    const Value slope = layered.on_base(Op::gradient_from_height_, m.uv0().x() * 0.1);
    const Value on_other{&m.module,
                         m.module.add(Op::gradient_from_height_, {m.uv0().y().id}, other.id)};
    m.module.current_node = 3;
    for (const Value& wrong : {m.add(slope, on_other), m.mix_gradients(on_other, slope, 0.5)})
        EXPECT_FALSE(wrong);
    ASSERT_EQ(m.module.problems.size(), 2U);
    for (const Problem& problem : m.module.problems) {
        EXPECT_EQ(problem.node, 3U);
        EXPECT_NE(problem.message.find("dents"), std::string::npos) << problem.message;
        EXPECT_NE(problem.message.find("scratches"), std::string::npos) << problem.message;
    }
    EXPECT_FALSE(m.add(slope, m.from_height(m.uv0().y())));
    EXPECT_NE(m.module.problems.back().message.find("surface"), std::string::npos);
}

TEST(Base, MayBeAddedToAFlatGradient) {
    Layered layered;
    Material& m = layered.m;
    const Value bump = layered.on_base(Op::gradient_from_volume_, m.position());
    EXPECT_TRUE(m.add(bump, layered.on_base(Op::gradient_from_height_, m.number(1))));
    EXPECT_TRUE(m.module.problems.empty());
}

// A literal amount of 0 behaves like a uniform amount of 0.
TEST(Base, IsKeptByAnAmountOfZero) {
    Layered layered;
    Material& m = layered.m;
    const Value bump = layered.on_base(Op::gradient_from_volume_, m.position());
    m.output("base", layered.first);
    m.output("scaled", m.resolve(m.scale(bump, 0)));
    m.output("mixed", m.resolve(m.mix_gradients(m.scale(bump, 0), bump, 0)));
    m.output("added", m.resolve(m.add(m.scale(bump, 0), m.scale(bump, 0))));
    const Value other = m.add(m.scale(bump, 0), m.from_volume(m.position()));
    EXPECT_FALSE(other) << "one is on the surface";
    m.module.problems.clear();
    const Expanded material(m);
    for (const Sample& sample : samples(20, 18)) {
        const Surroundings around = point_at(torus(), sample.st, sample.pixel);
        for (size_t i = 1; i < 4; ++i)
            EXPECT_LE(glm::distance(material.vector(i, around), material.vector(0, around)), 1e-12)
                << i;
    }
}

TEST(Base, IsKeptWhereNothingIsAdded) {
    Layered layered;
    Material& m = layered.m;
    m.output("first", layered.first);
    m.output("flat", m.resolve(layered.on_base(Op::gradient_from_height_, m.number(1))));
    m.output("itself", m.resolve(layered.on_base(Op::gradient_from_normal_, layered.first)));
    m.output("bump", m.resolve(layered.on_base(Op::gradient_from_volume_, m.position())));
    m.output("vector", m.vector_of(layered.on_base(Op::gradient_from_volume_, m.position())));
    const Expanded material(m);
    for (const Sample& sample : samples(20, 18)) {
        const Surroundings around = point_at(sphere(), sample.st, sample.pixel);
        const dvec3 n1 = material.vector(0, around);
        EXPECT_LE(glm::distance(n1, material.vector(1, around)), 1e-12);
        EXPECT_LE(glm::distance(n1, material.vector(2, around)), 1e-7);
        EXPECT_NEAR(glm::length(material.vector(3, around)), 1, 1e-12);
    }
}

// A normal given in object space replaces the layers below, at full strength.
TEST(Base, APerturbedNormalIsReachedFromAnyBase) {
    Layered layered;
    Material& m = layered.m;
    const Value wanted = m.input(SurfaceInput::normal_) + m.vector(dvec3(0.1, 0.3, -0.2));
    m.output("from the surface", m.resolve(m.from_normal(wanted)));
    m.output("from the base", m.resolve(layered.on_base(Op::gradient_from_normal_, wanted)));
    const Expanded material(m);
    for (const Sample& sample : samples(20, 19)) {
        const Surroundings around = point_at(sphere(), sample.st, sample.pixel);
        const dvec3 truth = glm::normalize(sphere().normal(sample.st) + dvec3(0.1, 0.3, -0.2));
        EXPECT_LE(angle_deg(material.vector(0, around), truth), 1e-6);
        EXPECT_LE(angle_deg(material.vector(1, around), truth), 1e-6);
    }
}

// Applies a slope to a base with its tangents orthogonalised to the base again, as the reference
// demo does.
dvec3 on_rebuilt_tangents(dvec3 n1, dvec2 slope) {
    const dvec3 along_x(1, 0, 0);
    const dvec3 tangent = glm::normalize(along_x - n1 * glm::dot(n1, along_x));
    return glm::normalize(n1 - tangent * slope.x - glm::cross(n1, tangent) * slope.y);
}

// A point of the plane z = 0, with uv0 along x and y.
Surroundings on_level_plane() {
    Surroundings around = point_at(plane_with(dmat2(1)), dvec2(0.3, 0.4), dmat2(0.01));
    around.inputs[input_extra(SurfaceInput::normal_, Variant::value)] = {0, 0, 1};
    around.inputs[input_extra(SurfaceInput::position_, Variant::dx)] = {0.01, 0, 0};
    around.inputs[input_extra(SurfaceInput::position_, Variant::dy)] = {0, 0.01, 0};
    return around;
}

// Recomputes the rows of the table in docs/surface-gradient.md.
TEST(Base, RebuiltTangentsDifferByTheTableOfTheDocs) {
    Material m;
    const Value frame = m.frame(m.uv0(), WR_FRAME_derived, WR_SCALE_unit);
    const Value first =
        m.resolve(m.from_slope(vec2(m.input(texel).x(), m.input(texel).y()), frame));
    const Value detail = op(Op::derivative_, m.uv1(), frame);
    m.output("base", first);
    m.output("normal", m.resolve({&m.module, m.module.add(Op::gradient_from_derivative_,
                                                          {detail.id}, op(Op::base_, first).id)}));
    const Expanded material(m);
    const std::string docs = bytes_of(WRINKLE_SOURCE_DIR "/docs/surface-gradient.md");
    Surroundings around = on_level_plane();
    const auto difference = [&](double base, double tilt, int across, int direction) {
        const auto slope = [](double degrees, int turn) {
            const double angle = 5 * turn * degree;
            return std::tan(degrees * degree) * dvec2(std::cos(angle), std::sin(angle));
        };
        const dvec2 first_slope = slope(base, across), second = slope(tilt, direction);
        around.inputs[input_extra(texel, Variant::value)] = {first_slope.x, first_slope.y, 0, 0};
        around.inputs[input_extra(SurfaceInput::uv1_, Variant::value)] = {second.x, second.y};
        const dvec3 n1 = material.vector(0, around);
        EXPECT_NEAR(angle_deg(n1, dvec3(0, 0, 1)), base, 1e-9);
        return angle_deg(material.vector(1, around), on_rebuilt_tangents(n1, second));
    };
    const std::pair<double, double> rows[] = {{32, 5}, {32, 10}, {32, 20}, {32, 32}, {60, 32}};
    for (const auto& [base, tilt] : rows) {
        double along_u = 0, most = 0;
        for (int across = 0; across < 72; ++across)
            for (int direction = 0; direction < 72; ++direction) {
                const double here = difference(base, tilt, across, direction);
                if (across == 0) along_u = std::fmax(along_u, here);
                most = std::fmax(most, here);
            }
        char row[80];
        std::snprintf(row, sizeof row, "| %.0f° | %.0f° | %.1f° | %.1f° |\n", base, tilt, along_u,
                      most);
        EXPECT_NE(docs.find(row), docs.npos) << row;
    }
}

}  // namespace
}  // namespace wrinkle::test

// Tests of degenerate surface inputs: results are finite, and flat where documented. Also the
// steepest slopes, and bumps on a bumped base.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "property/material.h"

namespace wrinkle::test {
namespace {

constexpr uint32_t unit_methods[] = {WR_FRAME_vertex, WR_FRAME_derived, WR_FRAME_guess};

Value frame_of(Material& m, uint32_t method) {
    return method == WR_FRAME_guess ? m.guess_frame(m.uv0(), m.vector(dvec3(0.1, 0.2, 0.9)))
                                    : m.frame(m.uv0(), method, WR_SCALE_unit);
}

Surroundings ordinary() {
    return point_at(sphere(), dvec2(0.4, 0.3), dmat2(0.01, 0.002, -0.001, 0.01));
}

double tilt_of(dvec3 m_value, uint32_t method) {
    Material m;
    m.output("normal", m.resolve(m.from_tangent_normal(m.vector(m_value), frame_of(m, method))));
    const Surroundings around = ordinary();
    return angle_deg(Expanded(m).vector(0, around), normal_of(around));
}

TEST(TangentNormal, IsClampedAtASlopeOf128) {
    const double steepest = std::atan(128.0) * 57.29577951308232;
    EXPECT_NEAR(steepest, 89.552, 1e-3);
    for (const uint32_t method : unit_methods) {
        EXPECT_NEAR(tilt_of(dvec3(1, 0, 0), method), steepest, 1e-9);
        EXPECT_NEAR(tilt_of(dvec3(0, -1, 0), method), steepest, 1e-9);
        EXPECT_NEAR(tilt_of(dvec3(1, 0, 0.001), method), steepest, 1e-9);
        EXPECT_NEAR(tilt_of(dvec3(1, 0, 0.01), method), std::atan(100.0) * 57.29577951, 1e-6);
        EXPECT_NEAR(tilt_of(dvec3(0.3, 0, -0.4), method), std::atan(0.75) * 57.29577951, 1e-6)
            << "z is mirrored up";
    }
}

TEST(TangentNormal, NeedNotBeUnit) {
    for (const uint32_t method : unit_methods)
        for (const double length : {1e-3, 0.5, 200.0})
            EXPECT_NEAR(tilt_of(dvec3(0.3, -0.2, 0.8) * length, method),
                        tilt_of(dvec3(0.3, -0.2, 0.8), method), 1e-9);
}

TEST(TangentNormal, OfZeroLengthIsFlat) {
    // The guard against a vanishing normal adds 1e-18: 5.5e-11 degrees in double.
    for (const uint32_t method : unit_methods)
        EXPECT_LE(tilt_of(dvec3(0, 0, 0), method), 1e-9);
}

// One degenerate input, applied to every kind of gradient at once and one by one.
struct Spoilt {
    const char* name;
    void (*spoil)(Surroundings&);
    std::vector<std::string> flat;  // kinds that add nothing for this input
};

void no_uv_change(Surroundings& around) {
    for (const Variant variant : {Variant::dx, Variant::dy})
        for (const SurfaceInput uv : {SurfaceInput::uv0_, SurfaceInput::uv1_})
            set(around, uv, {0, 0}, variant);
}
void no_position_change(Surroundings& around) {
    for (const Variant variant : {Variant::dx, Variant::dy})
        set(around, SurfaceInput::position_, {0, 0, 0}, variant);
}

const Spoilt spoilt_cases[] = {
    {"uv_that_stands_still", no_uv_change, {"derived", "derived_uv", "exact", "height_of_uv"}},
    {"uv_along_a_line",
     [](Surroundings& around) {
         set(around, SurfaceInput::uv0_, {0.01, 0.02}, Variant::dx);
         set(around, SurfaceInput::uv0_, {0.02, 0.04}, Variant::dy);
         set(around, SurfaceInput::uv1_, {0, 0.01}, Variant::dx);
         set(around, SurfaceInput::uv1_, {0, 0.02}, Variant::dy);
     },
     {}},
    {"position_that_stands_still", no_position_change, {"derived", "derived_uv", "height_of_both"}},
    {"position_along_a_line",
     [](Surroundings& around) {
         const auto x = around.inputs.at(input_extra(SurfaceInput::position_, Variant::dx));
         set(around, SurfaceInput::position_, {2 * x[0], 2 * x[1], 2 * x[2]}, Variant::dy);
     },
     {}},
    {"nothing_changes",
     [](Surroundings& around) {
         no_uv_change(around);
         no_position_change(around);
     },
     {"derived", "derived_uv", "exact", "height_of_both", "height_of_uv"}},
    {"no_tangent",
     [](Surroundings& around) {
         set(around, SurfaceInput::tangent_, {0, 0, 0, 1});
     },
     {"vertex"}},
    {"tangent_without_a_sign",
     [](Surroundings& around) {
         auto& tangent = around.inputs.at(input_extra(SurfaceInput::tangent_, Variant::value));
         tangent[3] = 0;
     },
     {}},
    {"tangent_along_the_normal",
     [](Surroundings& around) {
         const dvec3 n = normal_of(around);
         set(around, SurfaceInput::tangent_, {n.x, n.y, n.z, 1});
     },
     {}},
    {"normal_of_another_length",
     [](Surroundings& around) {
         const dvec3 n = normal_of(around) * 1e-4;
         set(around, SurfaceInput::normal_, {n.x, n.y, n.z});
     },
     {}},
};

struct NamedGradient {
    std::string name;
    Value gradient;
};

std::vector<NamedGradient> all_kinds(Material& m) {
    const Value slope = m.vector(dvec2(0.3, -0.2));
    const Value n = m.input(SurfaceInput::normal_);
    return {
        {"vertex", m.from_slope(slope, m.frame(m.uv0(), WR_FRAME_vertex, WR_SCALE_unit))},
        {"derived", m.from_slope(slope, m.frame(m.uv1(), WR_FRAME_derived, WR_SCALE_unit))},
        {"derived_uv",
         m.from_slope(slope, m.frame(m.uv0() + m.uv1() * 0.5, WR_FRAME_derived, WR_SCALE_unit))},
        {"exact", m.from_slope(slope, m.frame(m.uv0(), WR_FRAME_exact, WR_SCALE_surface))},
        {"guess", m.from_slope(slope, m.guess_frame(m.uv0(), m.vector(dvec3(1, 0, 0))))},
        {"height", m.from_height(m.position().x() * 0.2)},
        {"height_of_both", m.from_height(m.position().x() * 0.2 + m.uv1().x() * 0.1)},
        {"height_of_uv", m.from_height(m.uv1().x() * 0.2)},
        {"volume", m.from_volume(m.position())},
        {"opposite normal", m.from_normal(-n)},
        {"normal in the plane", m.from_normal(cross(n, m.vector(dvec3(0.1, 0.7, 0.2))))},
        {"zero normal", m.from_normal(m.vector(dvec3(0, 0, 0)))},
    };
}

class DegenerateInput : public testing::TestWithParam<Spoilt> {};

TEST_P(DegenerateInput, IsFiniteAndFlatWhereDocumented) {
    Material m;
    const std::vector<NamedGradient> kinds = all_kinds(m);
    Value sum = m.flat();
    for (const NamedGradient& kind : kinds) {
        m.output(kind.name, m.resolve(kind.gradient));
        sum = m.add(sum, kind.gradient);
    }
    m.output("sum", m.resolve(sum));
    const Expanded material(m);
    Surroundings around = ordinary();
    GetParam().spoil(around);
    const dvec3 n = glm::normalize(normal_of(around));
    for (size_t output = 0; output <= kinds.size(); ++output) {
        const std::string& name = material.module().outputs[output].name;
        const dvec3 normal = material.vector(output, around);
        EXPECT_NEAR(glm::length(normal), 1, 1e-9) << name;
        const auto& flat = GetParam().flat;
        const bool is_flat = std::find(flat.begin(), flat.end(), name) != flat.end();
        EXPECT_LE(glm::distance(normal, n), is_flat ? 1e-12 : 2.0) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(Inputs, DegenerateInput, testing::ValuesIn(spoilt_cases),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(Degenerate, AHeightInSpaceNeedsNoDifferentials) {
    Material m;
    m.output("normal", m.resolve(m.from_height(m.position().x() * 0.2)));
    Surroundings around = ordinary();
    no_position_change(around);
    const dvec3 n = glm::normalize(normal_of(around));
    const dvec3 uphill = 0.2 * (dvec3(1, 0, 0) - n * n.x);
    const dvec3 expected = glm::normalize(n - uphill);
    EXPECT_LE(glm::distance(Expanded(m).vector(0, around), expected), 1e-12);
}

TEST(Degenerate, TangentSignOfZeroCountsAsNegative) {
    Material m;
    m.output("normal", m.resolve(m.from_tangent_normal(m.vector(dvec3(0.1, 0.5, 0.8)),
                                                       frame_of(m, WR_FRAME_vertex))));
    const Expanded material(m);
    std::array<dvec3, 3> normals;
    for (int w = -1; w <= 1; ++w) {
        Surroundings around = ordinary();
        around.inputs.at(input_extra(SurfaceInput::tangent_, Variant::value))[3] = w;
        normals[static_cast<size_t>(w + 1)] = material.vector(0, around);
    }
    EXPECT_EQ(normals[1], normals[0]);
    EXPECT_GT(glm::distance(normals[1], normals[2]), 0.1);
}

TEST(Degenerate, AUvThatTheGraphCollapsesIsFlat) {
    Material m;
    const Value line = vec2(m.uv0().x(), m.uv0().x() * 2), point = m.uv0() * 0;
    for (const Value& uv : {line, point}) {
        m.output("vertex", m.resolve(m.from_slope(m.vector(dvec2(0.3, 0.4)),
                                                  m.frame(uv, WR_FRAME_derived, WR_SCALE_unit))));
    }
    const Expanded material(m);
    const Surroundings around = ordinary();
    for (size_t output = 0; output < 2; ++output)
        EXPECT_LE(glm::distance(material.vector(output, around), normal_of(around)), 1e-12);
}

TEST(Degenerate, AGuessAlongTheNormalIsFlat) {
    Material m;
    m.output("normal",
             m.resolve(m.from_slope(m.vector(dvec2(0.3, 0.4)),
                                    m.guess_frame(m.uv0(), m.input(SurfaceInput::normal_) * 3))));
    const Surroundings around = ordinary();
    EXPECT_LE(glm::distance(Expanded(m).vector(0, around), normal_of(around)), 1e-12);
}

}  // namespace
}  // namespace wrinkle::test

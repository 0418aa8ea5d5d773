// Tests of resolved normals against surfaces displaced by smooth heights and differentiated
// numerically; they must agree to first order in the height, as a bump ignores only |h| times
// curvature.
#include <gtest/gtest.h>

#include <cmath>

#include "property/material.h"

namespace wrinkle::test {
namespace {

// Amplitude times frequency is constant when the height shrinks, so that slopes are constant too.
struct Wave {
    double amplitude;
    double frequency;  // per length
    double radius;
};

struct Bump {
    Value height;
    Value gradient;
};

struct BumpCase {
    const char* name;
    Bump (*build)(Material&, Wave);
};

Value position_wave(Material& m, Wave w) {
    return m.sin(dot(m.position(), m.vector(dvec3(0.6, -0.5, 0.62)) * w.frequency)) * w.amplitude;
}
Value uv_wave(Material& m, Value uv, Wave w) {
    return m.sin(uv.x() * w.frequency) * m.cos(uv.y() * (0.7 * w.frequency)) * w.amplitude;
}
Value soft_mask(Material& m) {
    return m.smoothstep(-0.6, 0.9, m.sin(m.position().y() * 3 + m.uv0().x()));
}
Bump whole(Material& m, Value height) {
    return {height, m.from_height(height)};
}

Bump of_position(Material& m, Wave w) {
    return whole(m, position_wave(m, w));
}
Bump of_uv0(Material& m, Wave w) {
    return whole(m, uv_wave(m, m.uv0(), w));
}
Bump of_uv1(Material& m, Wave w) {
    return whole(m, uv_wave(m, m.uv1(), w));
}
Bump of_normal(Material& m, Wave w) {
    const Value n = m.input(SurfaceInput::normal_);
    return whole(
        m, m.cos(dot(n, m.vector(dvec3(0.6, 0.5, -0.4)) * (w.frequency * w.radius))) * w.amplitude);
}
Bump mixed_by_a_mask(Material& m, Wave w) {
    return whole(m, m.mix(position_wave(m, w), uv_wave(m, m.uv1(), w), soft_mask(m)));
}
Bump masked_product(Material& m, Wave w) {
    const Value ramp = m.smoothstep(0.1, 0.8, op(Op::fract_, m.uv0().y() * 0.1));
    return whole(m, position_wave(m, w) * soft_mask(m) * 0.6 + uv_wave(m, m.uv0(), w) * ramp * 0.4);
}
Bump sum_of_gradients(Material& m, Wave w) {
    const Value a = position_wave(m, w) * 0.4, b = uv_wave(m, m.uv1(), w);
    return {a - b * 0.6, m.add(m.from_height(a), m.scale(m.from_height(b), -0.6))};
}
Bump mix_of_gradients(Material& m, Wave w) {
    const Value a = uv_wave(m, m.uv0(), w), b = uv_wave(m, m.uv1(), w);
    return {a * 0.3 + b * 0.7, m.mix_gradients(m.from_height(a), m.from_height(b), 0.7)};
}
Bump slopes_in_exact_frames(Material& m, Wave w) {
    const auto slopes = [&](Value uv) {
        const double f = w.frequency, g = 0.7 * f;
        const Value du = m.cos(uv.x() * f) * m.cos(uv.y() * g) * (w.amplitude * f);
        const Value dv = m.sin(uv.x() * f) * m.sin(uv.y() * g) * (-w.amplitude * g);
        return m.from_slope(vec2(du, dv), m.frame(uv, WR_FRAME_exact, WR_SCALE_surface));
    };
    const Value height = uv_wave(m, m.uv0(), w) * 0.6 + uv_wave(m, m.uv1(), w) * 0.4;
    return {height, m.add(m.scale(slopes(m.uv0()), 0.6), m.scale(slopes(m.uv1()), 0.4))};
}
Bump volume_gradient(Material& m, Wave w) {
    const Value k = m.vector(dvec3(0.6, -0.5, 0.62)) * w.frequency;
    const Value g = k * (m.cos(dot(m.position(), k)) * w.amplitude);
    return {position_wave(m, w), m.from_volume(g)};
}

constexpr BumpCase cases[] = {
    {"of_position", of_position},
    {"of_uv0", of_uv0},
    {"of_uv1", of_uv1},
    {"of_normal", of_normal},
    {"mixed_by_a_mask", mixed_by_a_mask},
    {"masked_product", masked_product},
    {"sum_of_gradients", sum_of_gradients},
    {"mix_of_gradients", mix_of_gradients},
    {"slopes_in_exact_frames", slopes_in_exact_frames},
    {"volume_gradient", volume_gradient},
};

struct Errors {
    double worst = 0;  // degrees
    double rms = 0;    // degrees
    double steepest = 0;
    int points = 0;
};

Errors errors_of(const Surface& surface, const BumpCase& bump_case, double shrink) {
    const Wave wave{0.001 * surface.radius * shrink, 400 / (surface.radius * shrink),
                    surface.radius};
    Material m;
    const Bump bump = bump_case.build(m, wave);
    m.output("normal", m.resolve(bump.gradient));
    m.output("height", bump.height);
    const Expanded material(m);
    Errors errors;
    for (const Sample& sample : samples(1200, 5)) {
        const auto height = [&](dvec2 st) { return material.number(1, values_at(surface, st)); };
        const dvec3 truth = displaced_normal(surface, height, sample.st);
        const double slope = std::tan(angle_deg(truth, surface.normal(sample.st)) / 57.29577951);
        if (slope > 0.5) continue;
        EXPECT_LE(std::abs(height(sample.st)), 0.001 * surface.radius * 1.0001);
        const Surroundings around = point_at(surface, sample.st, sample.pixel);
        const double error = angle_deg(material.vector(0, around), truth);
        errors.worst = std::fmax(errors.worst, error);
        errors.rms += error * error;
        errors.steepest = std::fmax(errors.steepest, slope);
        ++errors.points;
    }
    errors.rms = std::sqrt(errors.rms / errors.points);
    return errors;
}

class Displacement : public testing::TestWithParam<BumpCase> {};

TEST_P(Displacement, AgreesWithTheBumpOnCurvedSurfaces) {
    for (const Surface& surface : {sphere(), torus()}) {
        SCOPED_TRACE(surface.name);
        const Errors full = errors_of(surface, GetParam(), 1);
        EXPECT_LE(full.worst, 0.1);
        EXPECT_GE(full.points, 800);
        EXPECT_GE(full.steepest, 0.1) << "too flat to tell anything";
        const Errors half = errors_of(surface, GetParam(), 0.5);
        const Errors quarter = errors_of(surface, GetParam(), 0.25);
        EXPECT_NEAR(full.rms / half.rms, 2, 0.35);
        EXPECT_NEAR(half.rms / quarter.rms, 2, 0.35);
    }
}

// Without curvature the result is exact.
TEST_P(Displacement, IsExactOnAPlane) {
    const Errors errors = errors_of(tilted_plane(), GetParam(), 1);
    EXPECT_LE(errors.worst, 1e-6);
    EXPECT_GE(errors.points, 800);
}

INSTANTIATE_TEST_SUITE_P(Heights, Displacement, testing::ValuesIn(cases),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace wrinkle::test

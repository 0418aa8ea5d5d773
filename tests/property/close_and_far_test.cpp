// Tests of very close and very distant views, in float: dFdx of float interpolants at pixels of 1
// to 1e-6 uv, against the result in double at a pixel of size 1.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "property/in_float.h"

namespace wrinkle::test {
namespace {

struct Kind {
    const char* name;
    Value (*build)(Material&);
};

Value slope_of(Material& m) {
    return vec2(m.sin(m.uv0().x() * 7) * 0.4, m.cos(m.uv0().y() * 5) * 0.3);
}

const Kind kinds[] = {
    {"height_of_uv",
     [](Material& m) {
         return m.from_height(m.sin(m.uv0().x() * 40) * m.cos(m.uv0().y() * 30) * 0.01);
     }},
    {"height_of_position",
     [](Material& m) {
         return m.from_height(m.sin(dot(m.position(), m.vector(dvec3(9, -7, 8)))) * 0.03);
     }},
    {"exact_frame",
     [](Material& m) {
         return m.from_slope(slope_of(m), m.frame(m.uv0(), WR_FRAME_exact, WR_SCALE_surface));
     }},
    {"derived_frame",
     [](Material& m) {
         return m.from_slope(slope_of(m), m.frame(m.uv0(), WR_FRAME_derived, WR_SCALE_unit));
     }},
    {"vertex_frame",
     [](Material& m) {
         return m.from_slope(slope_of(m), m.frame(m.uv0(), WR_FRAME_vertex, WR_SCALE_unit));
     }},
    {"all_in_one", [](Material& m) {
         Value sum = m.from_height(m.sin(m.uv0().x() * 40) * 0.004);
         for (const uint32_t method : {WR_FRAME_exact, WR_FRAME_derived, WR_FRAME_vertex}) {
             const uint32_t scale = method == WR_FRAME_exact ? WR_SCALE_surface : WR_SCALE_unit;
             sum = m.add(sum,
                         m.scale(m.from_slope(slope_of(m), m.frame(m.uv0(), method, scale)), 0.3));
         }
         return sum;
     }}};

class CloseAndFar : public testing::TestWithParam<Kind> {};

// Rounds differentials as dFdx does, which subtracts two interpolants rounded to float. The
// position is relative to the eye, at a distance of a thousand pixels.
void quantise(Surroundings& around, double pixel) {
    for (const SurfaceInput input : {SurfaceInput::uv0_, SurfaceInput::position_})
        for (const Variant variant : {Variant::dx, Variant::dy}) {
            const Lanes here = around.inputs.at(input_extra(input, Variant::value));
            for (size_t i = 0; i < 3; ++i) {
                double& change = around.inputs.at(input_extra(input, variant))[i];
                const double seen = pixel * 1000 * (0.3 + 0.2 * static_cast<double>(i));
                const auto from = static_cast<float>(input == SurfaceInput::uv0_ ? here[i] : seen);
                const auto to = static_cast<float>(from + change);
                change = to - from;
            }
        }
}

struct Spot {
    dvec2 st;
    dmat2 pixel;  // size 1
};

// The uvs are between 0.25 and 1, where floats are coarsest within one tile.
std::vector<Spot> spots() {
    std::vector<Spot> result;
    for (const Sample& sample : samples(200, 41)) {
        const dvec2 st(0.1 * (sample.st.x + 3.01), 0.2 * (sample.st.y + 1.11));
        result.push_back({st, sample.pixel / glm::length(sample.pixel[0])});
    }
    return result;
}

struct Worst {
    double degrees = 0;
    double flattest = 1e9;  // minimum ratio of the tilt to the expected tilt
};

Worst worst_of(const Kind& kind, double pixel, bool differences) {
    Material m;
    m.output("normal", m.resolve(kind.build(m)));
    const Expanded material(m);
    const InFloat in_float(material);
    const Surface surface = plane_with(dmat2(1));
    Worst worst;
    for (const Spot& spot : spots()) {
        Surroundings around = point_at(surface, spot.st, spot.pixel);
        const dvec3 expected = material.vector(0, around);
        around = point_at(surface, spot.st, spot.pixel * pixel);
        if (differences) quantise(around, pixel);
        const dvec3 got = in_float.vector(0, around);
        EXPECT_NEAR(glm::length(got), 1, 1e-5) << pixel;
        worst.degrees = std::fmax(worst.degrees, angle_deg(expected, got));
        const dvec3 n = surface.normal(spot.st);
        const double tilt = angle_deg(expected, n);
        if (tilt > 3) worst.flattest = std::fmin(worst.flattest, angle_deg(got, n) / tilt);
    }
    return worst;
}

TEST_P(CloseAndFar, DifferencesOfFloatsGiveTheBumpToTheirPrecision) {
    for (const double pixel : {1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        const Worst worst = worst_of(GetParam(), pixel, true);
        EXPECT_LE(worst.degrees, pixel >= 1e-5 ? 0.1 : 1.5) << pixel;
        EXPECT_GE(worst.flattest, 0.9) << pixel;
    }
}

// Differentials given in full precision may be as small as the range of float allows for their
// area.
TEST_P(CloseAndFar, GivenDifferentialsGiveTheBumpOverTwelveDecades) {
    for (const double pixel : {1e4, 1e2, 1.0, 1e-3, 1e-5, 1e-6, 1e-7, 1e-8}) {
        const Worst worst = worst_of(GetParam(), pixel, false);
        EXPECT_LE(worst.degrees, 0.01) << pixel;
    }
}

// The only limit of a derived frame: the product of a length and a uv differential.
TEST(DerivedFrame, FadesWhereTheProductOfChangesIsBelowItsFloor) {
    Material m;
    const Value frame = m.frame(m.uv0(), WR_FRAME_derived, WR_SCALE_unit);
    m.output("normal", m.resolve(m.from_slope(m.vector(dvec2(0.5, 0)), frame)));
    const Expanded material(m);
    const Surface surface = plane_with(dmat2(1));
    const auto tilt = [&](double pixel) {
        const Surroundings around = point_at(surface, dvec2(0.3, 0.4), dmat2(pixel));
        return angle_deg(material.vector(0, around), surface.normal(dvec2(0.3, 0.4)));
    };
    const auto degrees = [](double slope) { return std::atan(slope) * 180 / std::numbers::pi; };
    EXPECT_NEAR(tilt(1), degrees(0.5), 1e-6);
    EXPECT_NEAR(tilt(1.01e-9), degrees(0.5), 1e-6) << "a product of 1.02e-18";
    EXPECT_NEAR(tilt(5e-10), degrees(0.5 / 4), 1e-6) << "of 0.25e-18";
    EXPECT_LT(tilt(1e-11), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Kinds, CloseAndFar, testing::ValuesIn(kinds),
                         [](const auto& instance) { return instance.param.name; });

// The same wave in world space, at this many uv units per length: by its height and by its slopes.
Expanded wave_at(double density, dvec2 origin) {
    Material m;
    const Value length = (m.uv0() - m.vector(origin)) * (1 / density);
    const Value x = length.x() * 9, y = length.y() * 7;
    const Value slope = vec2(m.cos(x) * m.cos(y) * 9, m.sin(x) * m.sin(y) * -7) * (0.02 / density);
    m.output("height", m.resolve(m.from_height(m.sin(x) * m.cos(y) * 0.02)));
    m.output("slopes",
             m.resolve(m.from_slope(slope, m.frame(m.uv0(), WR_FRAME_exact, WR_SCALE_surface))));
    return Expanded(m);
}

TEST(UvDensity, OneWorldHeightGivesOneBump) {
    const Surface plane = plane_with(dmat2(1));
    for (const double density : {0.1, 0.3, 1.0, 3.0, 10.0}) {
        const Surface surface = plane_with(dmat2(density));
        const InFloat material(wave_at(density, surface.uv0(dvec2(0))));
        const auto height = [](dvec2 st) { return 0.02 * std::sin(9 * st.x) * std::cos(7 * st.y); };
        for (const Sample& sample : samples(60, 19)) {
            const Surroundings around = point_at(surface, sample.st, sample.pixel);
            const dvec3 truth = displaced_normal(plane, height, sample.st);
            for (size_t output = 0; output < 2; ++output)
                EXPECT_LE(angle_deg(material.vector(output, around), truth), 0.01) << density;
        }
    }
}

}  // namespace
}  // namespace wrinkle::test

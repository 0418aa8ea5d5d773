// Tests of single lobes of the shaded view against published figures, measured by integrators of
// other projects or derived from the papers.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "furnace.h"
#include "gpu/albedo.h"

namespace wrinkle::gpu {
namespace {

using glm::dvec3;

dvec3 slanted(double cosine) {
    return {std::sqrt(1 - cosine * cosine), 0, cosine};
}

// The mean of an albedo over the hemisphere, weighted by the cosine.
template <typename F>
double mean_albedo(F of) {
    constexpr int steps = 200;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double cosine = (i + 0.5) / steps;
        sum += 2 * of(cosine) * cosine / steps;
    }
    return sum;
}

TEST(Albedo, HasThePublishedMeans) {
    for (const auto& [roughness, expected] :
         {std::pair{0.25, 0.9874}, {0.5, 0.8823}, {0.75, 0.6562}, {1.0, 0.4092}}) {
        const double mean = mean_albedo([&, roughness = roughness](double cosine) {
            const glm::vec4 found = albedo(cosine, roughness);
            return static_cast<double>(found.x + found.y);
        });
        EXPECT_NEAR(mean, expected, 2e-3) << roughness;
    }
}

// Roughness, cosine, and the factors of F0 and of F90.
TEST(Albedo, SplitsAsPublished) {
    constexpr double rows[][4] = {
        {0.5, 0.2, 0.7499, 0.0983},  {0.5, 0.6, 0.8608, 0.0110},  {0.5, 1, 0.9158, 0},
        {1, 0.2, 0.6276, 0.0140},    {1, 0.6, 0.4098, 0.0017},    {1, 1, 0.3068, 0},
        {0.25, 0.2, 0.6812, 0.2648}, {0.25, 0.6, 0.9792, 0.0118}, {0.25, 1, 0.9949, 0}};
    for (const auto& [roughness, cosine, f0, f90] : rows) {
        const glm::vec4 found = albedo(cosine, roughness);
        EXPECT_NEAR(found.x, f0, 2e-3) << roughness << " " << cosine;
        EXPECT_NEAR(found.y, f90, 2e-3) << roughness << " " << cosine;
    }
}

// Figures of MaterialX 1.39 for the sheen of Zeltner et al.
TEST(Albedo, OfFuzzIsThePublishedFigure) {
    constexpr double cosines[] = {0.1, 0.3, 0.6, 1};
    const std::pair<double, std::array<double, 4>> rows[] = {
        {0.35, {0.4823, 0.1724, 0.0211, 0.0042}},
        {0.5, {0.5577, 0.3152, 0.0989, 0.0249}},
        {1, {0.6952, 0.5914, 0.4546, 0.3446}}};
    for (const auto& [roughness, expected] : rows)
        for (size_t i = 0; i < expected.size(); ++i)
            EXPECT_NEAR(albedo(cosines[i], roughness).w, expected[i], 2e-3)
                << roughness << " " << cosines[i];
}

// The albedo of a dielectric of ior 1.5 over black, without its multiple scattering. The figures
// are of Fresnel's formula; Schlick's approximation differs by 0.016 at a cosine of 0.2.
TEST_F(LobeTest, ADielectricReflectsThePublishedFigure) {
    constexpr double rows[][3] = {{0.25, 1, 0.0398},   {0.5, 1, 0.0370},   {1, 1, 0.0127},
                                  {0.25, 0.2, 0.2834}, {0.5, 0.2, 0.1340}, {1, 0.2, 0.0435}};
    for (const auto& [roughness, cosine, expected] : rows) {
        use({{"color", 0}, {"roughness", roughness}});
        const glm::vec4 white = albedo(cosine, roughness);
        const double lost = 1 - static_cast<double>(white.x + white.y);
        const double gain = 1 + 0.04 * lost / (1 - lost);
        EXPECT_NEAR(in_environment(slanted(cosine)) / gain, expected, cosine == 1 ? 2e-3 : 9e-3)
            << roughness << " " << cosine;
    }
}

// Oren and Nayar as Fujii has it, rho and sigma 1, without the multiple scattering of EON
// (Portsmouth 2024).
TEST_F(LobeTest, RoughDiffuseHasThePublishedAlbedo) {
    constexpr double rho = 0.5, mean = 0.8328;
    use({{"color", rho}, {"specular_weight", 0}, {"base_diffuse_roughness", 1}});
    const double multiple = rho * rho * mean / (1 - rho * (1 - mean));
    for (const auto& [cosine, expected] :
         {std::pair{0.1, 0.9743}, {0.3, 0.9195}, {0.6, 0.8404}, {1.0, 0.7765}}) {
        const double found = in_environment(slanted(cosine));
        EXPECT_NEAR((found - multiple) / (rho - multiple), expected, 2e-3) << cosine;
    }
}

// F82 (Hoffman 2023) of F0 .8 and edge color .5, in a mirror direction: the half vector is the
// normal, and the lobe that of a white metal.
TEST_F(LobeTest, AMetalHasTheEdgeOfItsColor) {
    constexpr double roughness = 0.2;
    for (const auto& [cosine, expected] :
         {std::pair{0.999, 0.8}, {0.5, 0.74471}, {1 / 7.0, 0.44627}, {0.05, 0.66523}}) {
        const dvec3 eye = slanted(cosine), light(-eye.x, 0, eye.z);
        const auto of = [&](double color, double edge) {
            use({{"color", color},
                 {"specular_color", edge},
                 {"metalness", 1},
                 {"roughness", roughness}});
            return lit(light, eye);
        };
        const glm::vec4 white = albedo(cosine, roughness);
        const double lost = 1 / static_cast<double>(white.x + white.y) - 1;
        const double found = of(0.8, 0.5) * (1 + lost) / (of(1, 1) * (1 + 0.8 * lost));
        EXPECT_NEAR(found, expected, 2e-3) << cosine;
    }
}

// The factor that inner reflections of a coat of ior 1.6 leave of a base: rough and smooth ones of
// albedo 0.5, and a rough one of 0.1. A black base leaves the reflection of the coat, which is
// subtracted.
TEST_F(LobeTest, ACoatDarkensAsDerived) {
    const dvec3 eye(0, 0, 1);
    const auto below = [&](const Values& base, double darkening) {
        const auto seen = [&](const Values& values, double coat) {
            Values all = values;
            all.insert(all.end(), {{"coat_weight", 1}, {"coat_darkening", coat}});
            use(all);
            return in_environment(eye);
        };
        const Values black{{"color", 0}, {"specular_weight", 0}};
        return seen(base, darkening) - seen(black, darkening);
    };
    const std::pair<Values, double> rows[] = {
        {{{"color", 0.5}, {"specular_weight", 0}}, 0.5176},
        {{{"color", 0.1}, {"specular_weight", 0}}, 0.3734},
        {{{"color", 0.5}, {"metalness", 1}, {"roughness", 0}}, 0.9727}};
    for (const auto& [base, expected] : rows)
        EXPECT_NEAR(below(base, 1) / below(base, 0), expected, 2e-3)
            << testing::PrintToString(base);
}

// Summed over directional lights, white metals reflect everything.
TEST_F(LobeTest, LightsOnAWhiteMetalAddUpToOne) {
    constexpr int rings = 32, sectors = 16;
    for (const auto& [roughness, cosine] :
         {std::pair{0.5, 1.0}, {0.75, 0.3}, {0.75, 1.0}, {1.0, 0.3}, {1.0, 1.0}}) {
        use({{"color", 1}, {"metalness", 1}, {"roughness", roughness}});
        double sum = 0;
        for (int i = 0; i < rings; ++i)
            for (int k = 0; k < sectors; ++k) {
                const double sine = std::sqrt((i + 0.5) / rings);
                const double turn = (k + 0.5) / sectors * std::numbers::pi;
                const dvec3 light(sine * std::cos(turn), sine * std::sin(turn),
                                  std::sqrt(1 - sine * sine));
                sum += lit(light, slanted(cosine)) / light.z / (rings * sectors);
            }
        EXPECT_NEAR(sum, 1, 0.01) << roughness << " " << cosine;
    }
}

}  // namespace
}  // namespace wrinkle::gpu

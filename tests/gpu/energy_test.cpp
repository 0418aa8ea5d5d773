// Energy of the shaded view: albedos, the white furnace, environments against directional lights,
// reciprocity. Oracles integrate the lobes as their papers give them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "furnace.h"
#include "gpu/albedo.h"
#include "gpu/environment.h"

namespace wrinkle::gpu {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::vec3;

constexpr double pi = std::numbers::pi;

// Smith's Lambda of GGX (Walter et al. 2007), of the tangent of the angle to the normal.
double smith(double cosine, double alpha) {
    const double tangent2 = 1 / (cosine * cosine) - 1;
    return (std::sqrt(1 + alpha * alpha * tangent2) - 1) / 2;
}

// Torrance-Sparrow with GGX and height-correlated masking (Heitz 2014), without Fresnel's term.
double ggx(dvec3 v, dvec3 l, double alpha) {
    const dvec3 h = glm::normalize(v + l);
    const double tangent2 = 1 / (h.z * h.z) - 1;
    const double facets =
        1 / (pi * alpha * alpha * std::pow(h.z, 4) * std::pow(1 + tangent2 / (alpha * alpha), 2));
    return facets / ((1 + smith(v.z, alpha) + smith(l.z, alpha)) * 4 * v.z * l.z);
}

// Integrals over the hemisphere around z of a lobe that is symmetric in y, times the cosine and
// each of the factors.
template <typename Lobe, typename Factors>
dvec3 integral(Lobe lobe, Factors factors) {
    constexpr int rings = 1200, sectors = 600;
    dvec3 sum(0);
    for (int i = 0; i < rings; ++i)
        for (int k = 0; k < sectors; ++k) {
            const double angle = (i + 0.5) / rings * pi / 2, turn = (k + 0.5) / sectors * pi;
            const dvec3 l(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn),
                          std::cos(angle));
            sum += factors(l) * (lobe(l) * l.z * std::sin(angle));
        }
    return sum * ((pi / 2 / rings) * (2 * pi / sectors));
}

TEST(Albedo, IsTheIntegralOfTheLobe) {
    for (const double roughness : {0.3, 0.5, 0.75, 1.0})
        for (const double cosine : {0.1, 0.4, 0.8, 1.0}) {
            const dvec3 v(std::sqrt(1 - cosine * cosine), 0, cosine);
            const dvec3 expected =
                integral([&](dvec3 l) { return ggx(v, l, roughness * roughness); },
                         [&](dvec3 l) {
                             const double m = glm::dot(v, glm::normalize(v + l));
                             const double edge = std::pow(1 - m, 5);
                             return dvec3(1 - edge, edge, m * edge * (1 - m));
                         });
            const glm::vec4 found = albedo(cosine, roughness);
            EXPECT_NEAR(found.x, expected.x, 2e-3);
            EXPECT_NEAR(found.y, expected.y, 2e-3);
            EXPECT_NEAR(found.z, expected.z, 2e-3);
        }
}

// Figures of two integrators for GGX, by the cosine of the view direction.
TEST(Albedo, OfAWhiteLobeIsThePublishedFigure) {
    const double cosines[] = {0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1};
    const std::pair<double, std::array<double, 7>> rows[] = {
        {0.25, {0.8941, 0.8968, 0.9463, 0.9829, 0.9915, 0.9945, 0.9960}},
        {0.5, {0.9331, 0.8916, 0.8482, 0.8443, 0.8717, 0.8973, 0.9158}},
        {0.75, {0.9049, 0.8484, 0.7720, 0.6871, 0.6469, 0.6303, 0.6269}},
        {1, {0.8478, 0.7602, 0.6416, 0.4989, 0.4115, 0.3513, 0.3069}}};
    for (const auto& [roughness, albedos] : rows)
        for (size_t i = 0; i < albedos.size(); ++i) {
            const glm::vec4 found = albedo(cosines[i], roughness);
            EXPECT_NEAR(found.x + found.y, albedos[i], 2e-3) << roughness << " " << cosines[i];
        }
}

// Mean of 65,536 samples of GGX for the eye on the normal, weighted by the masking.
double reflected(const Image& image, dvec3 normal, double roughness) {
    const double alpha = roughness * roughness;
    const dvec3 side = glm::normalize(glm::cross(normal, dvec3(0.3, 0.9, -0.2)));
    const dvec3 other = glm::cross(normal, side);
    constexpr int count = 256;
    double sum = 0, weights = 0;
    for (int i = 0; i < count * count; ++i) {
        const double u = (i / count + 0.5) / count, turn = (i % count + 0.5) / count * 2 * pi;
        const double cosine = std::sqrt((1 - u) / (1 + (alpha * alpha - 1) * u));
        const double sine = std::sqrt(1 - cosine * cosine);
        const dvec3 h =
            sine * std::cos(turn) * side + sine * std::sin(turn) * other + cosine * normal;
        const dvec3 light = 2 * cosine * h - normal;
        const double across = glm::dot(light, normal);
        if (across <= 0) continue;
        const dvec2 at = equirect_uv(light) * dvec2(image.width, image.height);
        const auto x = std::min(static_cast<uint32_t>(at.x), image.width - 1);
        const auto y = std::min(static_cast<uint32_t>(at.y), image.height - 1);
        const double weight = 1 / (1 + smith(across, alpha));
        sum += weight * static_cast<double>(image.texel(x, y)[1]);
        weights += weight;
    }
    return sum / weights;
}

// Numbers in [0, 1), the same in each run.
class Draws {
public:
    double operator()() {
        state_ = state_ * 6364136223846793005U + 1442695040888963407U;
        return static_cast<double>(state_ >> 40) / (1 << 24);
    }

private:
    uint64_t state_ = 1;
};

const Values white{{"color", 1},
                   {"coat_color", 1},
                   {"fuzz_color", 1},
                   {"subsurface_color", 1},
                   {"specular_color", 1}};
const std::vector<std::string> weights = {
    "metalness",       "roughness",        "base_diffuse_roughness",
    "specular_weight", "coat_weight",      "specular_roughness_anisotropy",
    "coat_roughness",  "coat_darkening",   "fuzz_weight",
    "fuzz_roughness",  "subsurface_weight"};

TEST_F(FurnaceTest, AWhiteMaterialVanishes) {
    const auto expect_one = [&](const Values& values) {
        const auto [low, high] = extremes(values);
        EXPECT_GT(low, 0.99) << testing::PrintToString(values);
        EXPECT_LT(high, 1.01) << testing::PrintToString(values);
    };
    // One input at a time, over a base, a coat and fuzz that are there.
    for (const std::string& name : weights)
        for (const double value : {0.0, 0.1, 0.3, 0.6, 1.0})
            for (const double layers : {0.0, 1.0}) {
                Values all = white;
                for (const char* layer : {"coat_weight", "fuzz_weight"})
                    all.emplace_back(layer, layers);
                all.emplace_back(name, value);
                expect_one(all);
            }
    Draws random;
    for (int i = 0; i < 200; ++i) {
        Values all = white;
        for (const std::string& name : weights)
            all.emplace_back(name, random());
        all.emplace_back("specular_ior", 1 + 1.5 * random());
        all.emplace_back("coat_ior", 1 + random());
        // The weight is a factor of a metal's reflection: below 1 it absorbs.
        all.emplace_back(i % 2 ? "metalness" : "specular_weight", i % 2 ? 0 : 1 + random());
        expect_one(all);
    }
}

TEST_F(FurnaceTest, NoMaterialGivesMoreThanItGets) {
    Draws random;
    for (int i = 0; i < 300; ++i) {
        Values values;
        for (const std::string& name : weights)
            values.emplace_back(name, random());
        for (const auto& [name, one] : white)
            values.emplace_back(name, random());
        for (const char* name : {"base_weight", "occlusion"})
            values.emplace_back(name, random());
        values.emplace_back("specular_ior", 1 + 1.5 * random());
        values.emplace_back("coat_ior", 1 + random());
        const auto [low, high] = extremes(values);
        EXPECT_LT(high, 1) << testing::PrintToString(values);
        EXPECT_GE(low, 0) << testing::PrintToString(values);
    }
}

// The mean over directional lights, weighted by the cosine, is the light of an environment of 1.
TEST_F(LobeTest, DirectionalLightsAddUpToTheEnvironment) {
    const std::vector<Values> materials = {
        {{"color", 0.5}, {"roughness", 0.5}},
        {{"color", 0.7}, {"roughness", 0.6}, {"base_diffuse_roughness", 1}},
        {{"color", 0.6}, {"roughness", 0.7}, {"metalness", 1}},
        {{"color", 0.6}, {"roughness", 0.7}, {"metalness", 1}, {"specular_color", 0.3}},
        {{"color", 0.4}, {"roughness", 0.6}, {"coat_weight", 1}, {"coat_roughness", 0.6}}};
    for (const Values& values : materials) {
        use(values);
        for (const double slant : {0.0, 0.9}) {
            const dvec3 eye(std::sin(slant), 0, std::cos(slant));
            constexpr int rings = 40, sectors = 24;
            double sum = 0;
            for (int i = 0; i < rings; ++i)
                for (int k = 0; k < sectors; ++k) {
                    const double sine = std::sqrt((i + 0.5) / rings);
                    const double turn = (k + 0.5) / sectors * pi;  // the other half mirrors it
                    const dvec3 light(sine * std::cos(turn), sine * std::sin(turn),
                                      std::sqrt(1 - sine * sine));
                    sum += lit(light, eye) / light.z;
                }
            const double mean = sum / (rings * sectors), expected = in_environment(eye);
            EXPECT_NEAR(mean, expected, 0.015 * expected)
                << testing::PrintToString(values) << " at " << slant;
        }
    }
}

// Single lobes, without the gain for multiple scattering, which depends on the eye only.
TEST_F(LobeTest, LightAndEyeCanBeExchanged) {
    struct Single {
        Values values;
        double roughness, f0;  // arguments of the gain
    };
    const std::vector<Single> lobes = {
        {{{"color", 0.5}, {"specular_weight", 0}, {"base_diffuse_roughness", 0.8}}, 0, 0},
        {{{"color", 0.9}, {"roughness", 0.3}, {"metalness", 1}}, 0.3, 0.9},
        {{{"color", 0.9},
          {"roughness", 0.6},
          {"metalness", 1},
          {"specular_color", 0.5},
          {"specular_roughness_anisotropy", 0.7}},
         0.6,
         0.9},
        {{{"color", 0}, {"roughness", 0.5}}, 0.5, 0.04},
        {{{"color", 0}, {"specular_weight", 0}, {"coat_weight", 1}, {"coat_roughness", 0.5}},
         0.5,
         std::pow(0.6 / 2.6, 2)}};
    const std::pair<dvec3, dvec3> directions[] = {{{0.5, 0.2, 0.8}, {-0.6, 0.5, 0.5}},
                                                  {{0.9, 0.1, 0.3}, {-0.2, -0.3, 0.9}},
                                                  {{0, 0, 1}, {0.7, -0.6, 0.2}}};
    for (const auto& [values, roughness, f0] : lobes) {
        use(values);
        const auto from_to = [&, roughness = roughness, f0 = f0](dvec3 light, dvec3 eye) {
            const glm::vec4 white = albedo(eye.z, roughness);
            const double all = static_cast<double>(white.x + white.y);
            return lit(light, eye) / light.z / (1 + f0 * (1 - all) / all);
        };
        for (const auto& [one, other] : directions) {
            const dvec3 a = glm::normalize(one), b = glm::normalize(other);
            const double there = from_to(a, b), back = from_to(b, a);
            EXPECT_GT(there, 0);
            EXPECT_NEAR(there, back, 2e-3 * there) << testing::PrintToString(values);
        }
    }
}

// A plane that faces the eye reflects the mean of the studio over the lobe.
TEST_F(LobeTest, AMetalReflectsTheStudioAsManySamplesDo) {
    renderer->set_mood(Mood::studio);
    const Image studio = environment_of(Mood::studio);
    for (const double roughness : {0.1, 0.3, 0.6, 1.0}) {
        double found = 0, expected = 0;
        for (int i = 0; i < 12; ++i) {
            const double yaw = i * 0.55 - 3, pitch = std::sin(i * 1.7) * 0.9;
            const dvec3 n(std::cos(pitch) * std::sin(yaw), std::sin(pitch),
                          std::cos(pitch) * std::cos(yaw));
            use({{"color", 1}, {"roughness", roughness}, {"metalness", 1}});
            scene.object =
                glm::rotate(glm::rotate(glm::mat4(1), static_cast<float>(yaw), vec3(0, 1, 0)),
                            static_cast<float>(-pitch), vec3(1, 0, 0));
            found += in_environment(n);
            expected += reflected(studio, n, roughness);
        }
        EXPECT_NEAR(found, expected, 0.02 * expected) << roughness;
    }
}

}  // namespace
}  // namespace wrinkle::gpu

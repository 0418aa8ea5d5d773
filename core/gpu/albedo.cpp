#include "gpu/albedo.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "base/fuzz.h"

namespace wrinkle::gpu {
namespace {

constexpr int samples = 1024;
constexpr double turn = 2 * std::numbers::pi;
constexpr double least_alpha = 0.002, least_cosine = 1e-3;

// Two dimensions of Roberts' sequence (2018), evenly spread in the unit square.
struct Point {
    double x, y;
};
Point point(int i) {
    const auto fraction = [&](double step) {
        const double value = 0.5 + step * i;
        return value - std::floor(value);
    };
    return {fraction(0.7548776662466927), fraction(0.5698402909980532)};
}

glm::dvec3 direction(double cosine, double angle) {
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return {sine * std::cos(angle), sine * std::sin(angle), cosine};
}

// Samples the visible normals (Heitz, JCGT 7(4) 2018), which leave the weight G2 / G1.
glm::dvec3 visible_half_vector(glm::dvec3 v, double alpha, Point xi) {
    const glm::dvec3 stretched = glm::normalize(glm::dvec3(alpha * v.x, alpha * v.y, v.z));
    const double flat = std::hypot(stretched.x, stretched.y);
    const glm::dvec3 t =
        flat > 0 ? glm::dvec3(-stretched.y, stretched.x, 0.0) / flat : glm::dvec3(1, 0, 0);
    const glm::dvec3 b = glm::cross(stretched, t);
    const double r = std::sqrt(xi.x), x = r * std::cos(turn * xi.y);
    const double s = 0.5 * (1 + stretched.z), full = std::sqrt(1 - x * x);
    const double y = (1 - s) * full + s * r * std::sin(turn * xi.y);
    const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
    const glm::dvec3 h = x * t + y * b + z * stretched;
    return glm::normalize(glm::dvec3(alpha * h.x, alpha * h.y, std::max(h.z, 1e-9)));
}

double smith_lambda(double cosine, double alpha) {
    const double tangent2 = (1 - cosine * cosine) / (cosine * cosine);
    return 0.5 * (std::sqrt(1 + alpha * alpha * tangent2) - 1);
}

glm::dvec3 ggx_albedo(double cosine, double roughness) {
    const double alpha = std::max(roughness * roughness, least_alpha);
    const glm::dvec3 v = direction(cosine, 0);
    const double masking = 1 + smith_lambda(cosine, alpha);
    glm::dvec3 sum(0);
    for (int i = 0; i < samples; ++i) {
        const glm::dvec3 h = visible_half_vector(v, alpha, point(i));
        const double m = glm::dot(v, h), out = 2 * m * h.z - v.z;
        if (out <= 0) continue;
        const double weight = masking / (masking + smith_lambda(out, alpha));
        const double edge = std::pow(1 - m, 5);
        sum += weight * glm::dvec3(1 - edge, edge, m * edge * (1 - m));
    }
    return sum / static_cast<double>(samples);
}

}  // namespace

glm::vec4 albedo(double cosine, double roughness) {
    const double clamped = std::clamp(cosine, least_cosine, 1.0);
    return {glm::vec3(ggx_albedo(clamped, roughness)), fuzz_albedo(clamped, roughness)};
}

std::vector<glm::vec4> albedo_table() {
    std::vector<glm::vec4> table;
    for (int row = 0; row < albedo_side; ++row)
        for (int i = 0; i < albedo_side; ++i) {
            const double t = static_cast<double>(i) / (albedo_side - 1);
            table.push_back(albedo(t * t, static_cast<double>(row) / (albedo_side - 1)));
        }
    return table;
}

}  // namespace wrinkle::gpu

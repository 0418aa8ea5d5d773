#include "sphere.h"

#include <cmath>
#include <vector>

namespace wrinkle::textures {

namespace {

// sin(pi t) for t in [0, 1/4] and cos(pi t) likewise, by their series, so that no machine's maths
// library shows in the texture.
double series(double t, double first, int power) {
    constexpr double pi = 3.14159265358979323846;
    const double square = pi * pi * t * t;
    double term = first, sum = first;
    for (int k = power + 1; k < 24; k += 2) {
        term *= -square / (k * (k + 1));
        sum += term;
    }
    return sum;
}

double sin_pi(double t);

double cos_pi(double t) {
    t = std::fabs(t - 2 * std::floor(t / 2 + 0.5));  // [0, 1]
    if (t > 0.5) return -cos_pi(1 - t);
    return t <= 0.25 ? series(t, 1, 0) : sin_pi(0.5 - t);
}

double sin_pi(double t) {
    constexpr double pi = 3.14159265358979323846;
    if (t >= 0 && t <= 0.25) return series(t, pi * t, 1);
    return cos_pi(t - 0.5);
}

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector normalized(const Vector& a) {
    const double length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}

struct Bump {
    Vector center;
    double height;
    double rim;  // cosine of the angular radius
};

// a and b with every sign, in each of the three cyclic places (0, a, b), (b, 0, a), (a, b, 0).
void add_cyclic(std::vector<Bump>& bumps, double a, double b, double height, double rim) {
    for (const double p : {-a, a})
        for (const double q : {-b, b})
            for (const Vector& corner : {Vector{0, p, q}, Vector{q, 0, p}, Vector{p, q, 0}})
                bumps.push_back({normalized(corner), height, rim});
}

std::vector<Bump> make_bumps() {
    const double golden = (1 + std::sqrt(5.0)) / 2;
    constexpr double boss = 0.035, boss_rim = 0.96, dimple = -0.05, dimple_rim = 0.94;
    std::vector<Bump> bumps;
    add_cyclic(bumps, golden, 1, dimple, dimple_rim);
    add_cyclic(bumps, 1 / golden, golden, boss, boss_rim);
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0})
                bumps.push_back({normalized({x, y, z}), boss, boss_rim});
    return bumps;
}

}  // namespace

Vector sphere_point(double u, double v) {
    const double radius = sin_pi(v), around = 2 * u - 1;
    return {radius * sin_pi(around), -cos_pi(v), radius * cos_pi(around)};
}

Vector ball_normal(const Vector& p) {
    static const std::vector<Bump> bumps = make_bumps();
    Vector normal = p;
    for (const Bump& bump : bumps) {
        const double t = (dot(p, bump.center) - bump.rim) / (1 - bump.rim);
        if (t <= 0) continue;
        const double slope = bump.height * 6 * t * (1 - t) / (1 - bump.rim);
        const double outward = dot(p, bump.center);
        for (size_t i = 0; i < 3; ++i)
            normal[i] -= slope * (bump.center[i] - outward * p[i]);
    }
    return normalized(normal);
}

}  // namespace wrinkle::textures

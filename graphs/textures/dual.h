// A number with its two derivatives by u and v: a height written once gives its slopes exactly.
// Only operations that IEEE 754 rounds correctly, so every machine makes the same textures.
#pragma once

#include <cmath>

namespace wrinkle::textures {

struct Dual {
    double value = 0;
    double du = 0;
    double dv = 0;

    Dual() = default;
    Dual(double constant) : value(constant) {}  // NOLINT: constants stand in formulas as they are
    Dual(double value_, double du_, double dv_) : value(value_), du(du_), dv(dv_) {}
};

inline Dual operator-(Dual a) {
    return {-a.value, -a.du, -a.dv};
}

inline Dual operator+(Dual a, Dual b) {
    return {a.value + b.value, a.du + b.du, a.dv + b.dv};
}

inline Dual operator-(Dual a, Dual b) {
    return a + -b;
}

inline Dual operator*(Dual a, Dual b) {
    return {a.value * b.value, a.du * b.value + a.value * b.du, a.dv * b.value + a.value * b.dv};
}

inline Dual operator/(Dual a, double b) {
    return {a.value / b, a.du / b, a.dv / b};
}

// 0 with zero slopes at and below 0.
inline Dual root(Dual a) {
    if (a.value <= 0) return 0;
    const double value = std::sqrt(a.value);
    return {value, a.du / (2 * value), a.dv / (2 * value)};
}

inline Dual smaller(Dual a, Dual b) {
    return a.value < b.value ? a : b;
}

inline Dual larger(Dual a, Dual b) {
    return a.value < b.value ? b : a;
}

inline Dual magnitude(Dual a) {
    return a.value < 0 ? -a : a;
}

inline Dual fraction(Dual a) {
    return a - std::floor(a.value);
}

// 0 below 0, 1 above 1, t^2 (3 - 2t) between.
inline Dual smooth(Dual t) {
    if (t.value <= 0) return 0;
    if (t.value >= 1) return 1;
    return t * t * (3 - 2 * t);
}

// A smooth wave of period 2 with 1 at 0 and -1 at 1.
inline Dual wave(Dual t) {
    const Dual at = fraction(t / 2) * 2;
    return 1 - 2 * smooth(magnitude(1 - magnitude(1 - at)));
}

}  // namespace wrinkle::textures

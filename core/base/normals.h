// Angles between normals, and the limits of slopes that are read from normals.
#pragma once

#include <cmath>
#include <limits>

namespace wrinkle {

// A normal (x, y, z) has the slope -xy / depth with depth = max(|z|, max(|x|, |y|) / max_slope,
// min_depth).
//
// Source: Mikkelsen 2020, "Surface Gradient-Based Bump Mapping Framework", TspaceNormalToDerivative
// (128); the floor makes a zero vector flat.
inline constexpr double max_slope = 128;
inline constexpr double min_depth = 1e-6;

// Returns the angle in degrees, independent of the vector lengths. Uses atan2, which is exact where
// acos of a dot product is not. Returns NaN if either vector is zero. Vector is any type with a[0],
// a[1], a[2].
template <class Vector>
double degrees_between(const Vector& a, const Vector& b) {
    const double x = a[1] * b[2] - a[2] * b[1];
    const double y = a[2] * b[0] - a[0] * b[2];
    const double z = a[0] * b[1] - a[1] * b[0];
    const double sine = std::sqrt(x * x + y * y + z * z);
    const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    if (sine == 0 && cosine == 0) return std::numeric_limits<double>::quiet_NaN();
    return std::atan2(sine, cosine) * 57.29577951308232;
}

}  // namespace wrinkle

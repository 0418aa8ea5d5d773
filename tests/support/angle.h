// Angles, and the angle between two vectors of three numbers in degrees, of any lengths.
#pragma once

#include <cmath>

namespace wrinkle::test {

inline constexpr double degrees = 57.29577951308232;  // per radian
inline constexpr double degree = 1 / degrees;         // in radians
inline constexpr double full_circle = 6.283185307179586;

// Uses the sine too, because the cosine loses small angles. Vector: any type with a[0], a[1], a[2].
template <class Vector>
double angle_deg(const Vector& a, const Vector& b) {
    const double x = a[1] * b[2] - a[2] * b[1];
    const double y = a[2] * b[0] - a[0] * b[2];
    const double z = a[0] * b[1] - a[1] * b[0];
    const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return std::atan2(std::sqrt(x * x + y * y + z * z), cosine) * degrees;
}

}  // namespace wrinkle::test

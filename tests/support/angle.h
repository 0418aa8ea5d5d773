// Angles, and the one between two vectors of three numbers in degrees; their lengths do not matter.
#pragma once

#include <cmath>

namespace wrinkle::test {

inline constexpr double degrees = 57.29577951308232;  // of one radian
inline constexpr double full_circle = 6.283185307179586;

// By the sine too, as the cosine alone loses small angles. Anything with a[0], a[1], a[2].
template <class Vector>
double angle_deg(const Vector& a, const Vector& b) {
    const double x = a[1] * b[2] - a[2] * b[1];
    const double y = a[2] * b[0] - a[0] * b[2];
    const double z = a[0] * b[1] - a[1] * b[0];
    const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return std::atan2(std::sqrt(x * x + y * y + z * z), cosine) * degrees;
}

}  // namespace wrinkle::test

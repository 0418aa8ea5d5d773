// The angle between two vectors of three numbers.
#pragma once

#include <cmath>
#include <limits>

namespace wrinkle {

// In degrees; lengths do not matter. By atan2: exact where acos of a dot product is not. NaN when
// either vector has no direction. Anything with a[0], a[1], a[2].
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

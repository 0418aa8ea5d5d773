// Piecewise curves through given points: values of type V at rising positions of x, constant
// outside. Each is the exact mean over a box of `width` around x, and the derivative of that mean.
//
//   constant  the value of the point to the left
//   linear    straight between two points
//   ease      t t (3 - 2 t) between two points: no slope at the points
//   smooth    a cubic Hermite polynomial between two points with the slopes of F. N. Fritsch and
//             J. Butland 1984 (PCHIP): C1, and monotone where the values are
//
// Positions are made to rise: each counts at least as the one before, and a gap has at least 1e-6,
// so equal positions are a hard edge. A width counts at least as 1e-5: no division by 0.
#pragma once

#include <vector>

#include "wrinkle/node.h"

namespace wrinkle::nodes {

enum class Interpolation { constant, linear, ease, smooth };
inline constexpr const char* interpolation_names[] = {"constant", "linear", "ease", "smooth"};

template <class V>
struct Knots {
    std::vector<sdk::Float> position;
    std::vector<V> value;
};

template <class V>
V spline(const Knots<V>& knots, Interpolation interpolation, sdk::Float x, sdk::Float width);
extern template sdk::Float spline(const Knots<sdk::Float>&, Interpolation, sdk::Float, sdk::Float);
extern template sdk::vec3 spline(const Knots<sdk::vec3>&, Interpolation, sdk::Float, sdk::Float);

}  // namespace wrinkle::nodes

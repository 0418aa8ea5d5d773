// The limits of slopes that are read from normals: a normal (x, y, z) has the slope -xy / depth
// with depth = max(|z|, max(|x|, |y|) / steepest_slope, smallest_depth).
//
// Source: Mikkelsen 2020, "Surface Gradient-Based Bump Mapping Framework", TspaceNormalToDerivative
// (128); the floor makes a zero vector flat.
#pragma once

namespace wrinkle {

inline constexpr double steepest_slope = 128;
inline constexpr double smallest_depth = 1e-6;

}  // namespace wrinkle

// The limits of slopes that are read from normals: a normal (x, y, z) has the slope -xy / depth
// with depth = max(|z|, max(|x|, |y|) / max_slope, min_depth).
//
// Source: Mikkelsen 2020, "Surface Gradient-Based Bump Mapping Framework", TspaceNormalToDerivative
// (128); the floor makes a zero vector flat.
#pragma once

namespace wrinkle {

inline constexpr double max_slope = 128;
inline constexpr double min_depth = 1e-6;

}  // namespace wrinkle

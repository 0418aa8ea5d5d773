// Interpolates a triangle's corner values at a row of points, into planes of floats as a program
// reads them. Double arithmetic with each operation rounded separately, so all instruction sets
// give identical bits.
//
// The barycentric weights of a point are 1 - s - t, s and t for corners 0, 1 and 2. If one is below
// 0, negative weights are clamped to 0 and the weights are normalised to sum 1. Loops process full
// SIMD vectors: they read and write up to `interpolate_padding` numbers past the last point.
#pragma once

#include <cstddef>
#include <cstdint>

namespace wrinkle {

inline constexpr size_t interpolate_padding = 8;

// Contents of plane number `plane`, from the first point of the row on: interpolated corner values,
// or one constant value.
struct VaryingInput {
    double corner[3];
    size_t plane;
};
struct FlatInput {
    float value;
    size_t plane;
};

struct TrianglePlanes {
    // s and t are affine in (u, v): both are 0 at `first`; `second` and `third` are the derivatives
    // of s and t by u and v.
    double first[2], second[2], third[2];
    const VaryingInput* linear = nullptr;
    size_t linear_count = 0;
    const FlatInput* constant = nullptr;
    size_t constant_count = 0;
};

struct PointRow {
    const double* u;  // u of each point; read to the end of the last SIMD vector
    double v;
    size_t count;
};

// Plane i begins at out + i * stride.
using Interpolate = void (*)(const TrianglePlanes& triangle, const PointRow& row, float* out,
                             size_t stride);

}  // namespace wrinkle

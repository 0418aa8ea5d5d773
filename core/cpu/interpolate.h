// What a triangle's corners make of places in a row: planes of numbers as a program reads them.
// Double arithmetic, each operation rounding by itself, so every instruction set has the same bits.
//
// A place's weights are s and t of corners 1 and 2, and 1 - s - t of corner 0; where one is below 0
// it is brought to 0, and the sum of the others back to 1. Loops run over whole vectors: they read
// and write up to `interpolated_behind` numbers behind the last place.
#pragma once

#include <cstddef>
#include <cstdint>

namespace wrinkle {

inline constexpr size_t interpolated_behind = 8;

// What a plane holds, from the number at the first place on.
struct LinearPlane {
    double corner[3];
    size_t plane;
};
struct ConstantPlane {
    float value;
    size_t plane;
};

struct TrianglePlanes {
    // s and t are linear in the place: 0 at `first`, and change by this per unit of u and v.
    double first[2], second[2], third[2];
    const LinearPlane* linear = nullptr;
    size_t linear_count = 0;
    const ConstantPlane* constant = nullptr;
    size_t constant_count = 0;
};

struct PlaceRow {
    const double* u;  // of each; read as far as whole vectors go
    double v;
    size_t count;
};

// Plane i begins at out + i * stride.
using Interpolate = void (*)(const TrianglePlanes& triangle, const PlaceRow& row, float* out,
                             size_t stride);

}  // namespace wrinkle

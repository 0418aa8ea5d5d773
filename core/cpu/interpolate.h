// What a triangle's corners make of places in a row: planes of numbers as a program reads them.
// Double arithmetic, each operation rounding by itself, so every instruction set has the same bits.
//
// A place's weights are s and t of corners 1 and 2, and 1 - s - t of corner 0. Loops run over whole
// vectors: they read and write up to `interpolated_behind` numbers behind the last place.
#pragma once

#include <cstddef>
#include <cstdint>

namespace wrinkle {

inline constexpr size_t interpolated_behind = 8;

struct TriangleRow {
    // s and t are linear in the place: 0 at `first`, and change by this per unit of u and v.
    double first[2], second[2], third[2];
    const double* u = nullptr;
    double v = 0;
    size_t count = 0;
    bool outside = false;  // weights below 0 are brought to 0, the others' sum back to 1
};

struct CornerValues {
    enum class Kind : uint8_t { linear, constant, other };  // others' planes are not touched
    Kind kind = Kind::other;
    double at[3] = {};  // the first one is the constant
};

// Plane i goes to out + i * stride.
using Interpolate = void (*)(const TriangleRow& row, const CornerValues* values, size_t planes,
                             float* out, size_t stride);

}  // namespace wrinkle

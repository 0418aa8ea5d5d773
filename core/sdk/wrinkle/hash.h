// Random numbers from integers, the same on every machine.
#pragma once

#include "wrinkle/region.h"

namespace wrinkle::sdk {

namespace detail {
// The PCG permutation (M. O'Neill 2014).
inline Uint permuted(Uint seed) {
    const Uint state = seed * 747796405u + 2891336453u;
    const Uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}
}  // namespace detail

// A well mixed integer of one to three integers, by one function of the generated code.
inline Uint hash(Uint x) {
    return function("hash(x)", detail::permuted)(x);
}
inline Uint hash(Int x) {
    return hash(Uint(x));
}
inline Uint hash(Int x, Int y) {
    return hash(Uint(x) + hash(Uint(y)));
}
inline Uint hash(Int x, Int y, Int z) {
    return hash(Uint(x) + hash(Uint(y) + hash(Uint(z))));
}

// A number in [0, 1) of the upper 24 bits.
inline Float unit_float(Uint bits) {
    return Float(bits >> 8u) * (1.0 / 16777216.0);
}

}  // namespace wrinkle::sdk

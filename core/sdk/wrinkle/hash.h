// Random numbers from integers, the same on every machine.
#pragma once

#include "wrinkle/region.h"

namespace wrinkle::sdk {

namespace detail {
// The PCG permutation (M. O'Neill 2014).
inline Uint permuted(Uint seed) {
    const Uint state = named("state", seed * 747796405u + 2891336453u);
    const Uint word = named("word", ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u);
    return (word >> 22u) ^ word;
}
}  // namespace detail

// A well mixed integer of one to three integers, by one function of the generated code.
inline Uint hash(Uint x) {
    return function("pcg_hash(x)", detail::permuted)(x);
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
// The same for whole numbers that are stored as floats, as by floor().
inline Uint hash(vec3 cell) {
    const auto of_cell = function("hash3(cell)", [](vec3 p) {
        const Uint z = named("z", hash(Int(p.z())));
        const Uint yz = named("yz", hash(Uint(Int(p.y())) + z));
        return hash(Uint(Int(p.x())) + yz);
    });
    return of_cell(cell);
}

// A number in [0, 1) of the upper 24 bits.
inline Float unit_float(Uint bits) {
    return Float(bits >> 8u) / named("two_24 // the upper 24 bits to [0, 1)", Float(16777216));
}

}  // namespace wrinkle::sdk

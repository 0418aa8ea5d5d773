// Random numbers of cells: the same on every machine, constant within a cell, so without slope.
#pragma once

#include <string>

#include "wrinkle/node.h"

namespace wrinkle::nodes {

inline constexpr char seed_doc[] = "Another seed gives other random numbers";

// Three numbers in [0, 1) from `bits` and two further hashes.
inline sdk::vec3 random3(sdk::Uint bits) {
    using namespace sdk;
    const auto numbers = function("random3(bits)", [](Uint bits) {
        const Uint second = named("second", hash(bits)), third = named("third", hash(second));
        return vec3(unit_float(bits), unit_float(second), unit_float(third));
    });
    return numbers(bits);
}

// Random bits of a cell and a number, both rounded to whole numbers, and a seed.
inline sdk::Uint random_bits(sdk::vec2 cell, sdk::Float id, int seed) {
    using namespace sdk;
    const auto bits = function("random_bits(cell, id, seed)", [](vec2 cell, Float id, Int seed) {
        const vec2 at = named("at", floor(cell + 0.5));
        const Uint of_id = named("of_id", hash(Uint(Int(floor(id + 0.5))) + hash(seed)));
        const Uint of_y = named("of_y", hash(Uint(Int(at.y())) + of_id));
        return hash(Uint(Int(at.x())) + of_y);
    });
    return bits(cell, id, Int(seed));
}

// The offset of a pattern in cells by its seed, -64 to 64 per axis.
inline sdk::vec3 seed_offset(int seed) {
    using namespace sdk;
    const auto along = [seed](int axis) {
        return 128 * unit_float(hash(Int(seed), Int(axis))) - 64;
    };
    return {along(0), along(1), along(2)};
}

// Calls a function of the generated code with the body body(moved, args...), where moved(p) is the
// position p, in cells, moved by the offset of the seed. The offset is a parameter of the function,
// unless the seed is 0, which has none.
template <class Body, class... Args>
sdk::Float seeded(int seed, const std::string& name, const std::string& parameters, Body body,
                  Args... args) {
    using namespace sdk;
    if (seed == 0) {
        const auto here = [&](Args... in) { return body([](auto p) { return p; }, in...); };
        return function((name + "(" + parameters + ")").c_str(), here)(args...);
    }
    const auto elsewhere = [&](vec3 offset, Args... in) {
        const auto moved = [&](auto p) {
            if constexpr (decltype(p)::lanes == 2)
                return p + offset.xy();
            else
                return p + offset;
        };
        return body(moved, in...);
    };
    return function((name + "(seed_offset, " + parameters + ")").c_str(), elsewhere)(
        seed_offset(seed), args...);
}

}  // namespace wrinkle::nodes

// Random numbers of cells: the same on every machine, constant within a cell, so without slope.
#pragma once

#include "wrinkle/node.h"

namespace wrinkle::nodes {

inline constexpr char seed_doc[] = "Another seed gives other random numbers";

// Three numbers in [0, 1) from `bits` and two further hashes.
inline sdk::vec3 random3(sdk::Uint bits) {
    using namespace sdk;
    const auto numbers = function("random3(bits)", [](Uint bits) {
        const Uint hashed = named("hashed", hash(bits)), third = named("third", hash(hashed));
        return vec3(unit_float(bits), unit_float(hashed), unit_float(third));
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

// The cell of a pattern that has the random numbers of another cell by its seed: for seeds other
// than 0 it is moved by up to 32768 cells per axis. Only the cell is, so that positions in it lose
// no digits.
inline sdk::vec3 seeded_cell(sdk::vec3 cell, int seed) {
    using namespace sdk;
    if (seed == 0) return cell;
    const auto along = [seed](int axis) {
        return floor(unit_float(hash(Int(seed), Int(axis))) * 65536) - 32768;
    };
    return cell + named("seed_offset // in cells, by the seed", vec3(along(0), along(1), along(2)));
}

}  // namespace wrinkle::nodes

// An instruction as the table of a module tells it apart: in four words, literals by their bits (-0
// and 0 are two). For core/ir/module.cpp alone.
#pragma once

#include <bit>
#include <cstdint>

#include "ir/module.h"

namespace wrinkle {

struct PackedInst {
    uint64_t head = 0, args = 0, more_args = 0, value = 0;
    bool operator==(const PackedInst&) const = default;
};

// From values at hand: read back from an Inst that was just written field by field, a word would
// have to wait for those writes.
inline PackedInst packed(Op op, Type type, uint8_t level, uint32_t extra, Id a, Id b, Id c, Id d,
                         double value) {
    return {static_cast<uint64_t>(op) | static_cast<uint64_t>(type) << 16 |
                static_cast<uint64_t>(level) << 24 | static_cast<uint64_t>(extra) << 32,
            a | static_cast<uint64_t>(b) << 32, c | static_cast<uint64_t>(d) << 32,
            std::bit_cast<uint64_t>(value)};
}

inline PackedInst packed(const Inst& inst) {
    return packed(inst.op, inst.type, inst.level, inst.extra, inst.arg[0], inst.arg[1], inst.arg[2],
                  inst.arg[3], inst.value);
}

inline Inst unpacked(const PackedInst& p) {
    const auto low = [](uint64_t word) { return static_cast<uint32_t>(word); };
    const auto high = [](uint64_t word) { return static_cast<uint32_t>(word >> 32); };
    return {static_cast<Op>(p.head & 0xFFFF),
            static_cast<Type>(p.head >> 16 & 0xFF),
            static_cast<uint8_t>(p.head >> 24 & 0xFF),
            {low(p.args), high(p.args), low(p.more_args), high(p.more_args)},
            high(p.head),
            std::bit_cast<double>(p.value)};
}

// Multilinear, then mixed downwards: literals differ in the highest bits of their value alone, and
// a slot is taken from the lowest bits.
inline uint64_t hash_of(const PackedInst& p) {
    uint64_t h = p.head * 0x9E3779B97F4A7C15U + p.args * 0xC2B2AE3D27D4EB4FU +
                 p.more_args * 0x165667B19E3779F9U + std::rotl(p.value, 32) * 0xD6E8FEB86659FD93U;
    h = (h ^ h >> 32) * 0xFF51AFD7ED558CCDU;
    return h ^ h >> 29;
}

}  // namespace wrinkle

// Which instruction of a module is equal to one at hand.
//
// An instruction is found by the newest of its operands: a few that read a value stand in a chain
// of that value. Mostly it was made just now, and its chain with it, so what is looked at is in the
// nearest cache, however large the module. Leaves, loops, calls and the many readers of one value
// stand in a hash table.
#pragma once

#include <bit>
#include <vector>

#include "ir/inst.h"

namespace wrinkle {

// An instruction in the four words that tell it apart: literals by their bits, -0 and 0 are two.
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

class InternTable {
public:
    explicit InternTable(size_t expected);  // instructions, to make room for

    // The equal one among `inst`, all of which are in here; poison where there is none.
    Id find(const PackedInst& wanted, const std::vector<Inst>& inst) const;
    // The last of `inst`, which find() did not find.
    void add(const PackedInst& added, const std::vector<Inst>& inst);

private:
    struct Readers {
        Id newest = poison;  // of those that have this value as their newest operand
        Id next = poison;    // in the chain that this one stands in
    };
    void add_to_slots(const PackedInst& added, Id id);
    void grow(const std::vector<Inst>& inst);

    std::vector<Readers> readers_;  // by Id
    std::vector<Id> slots_;         // open addressing; poison is free
    size_t taken_ = 0;
};

}  // namespace wrinkle

#include "ir/intern_table.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace wrinkle {
namespace {

constexpr int longest_chain = 8;

bool identical(const Inst& a, const Inst& b) {
    return a.op == b.op && a.type == b.type && a.level == b.level && a.extra == b.extra &&
           a.arg == b.arg && std::bit_cast<uint64_t>(a.value) == std::bit_cast<uint64_t>(b.value);
}

// Multilinear, then mixed downwards: literals differ in the highest bits of their value alone, and
// a slot is taken from the lowest bits.
uint64_t hash_of(const Inst& inst) {
    const uint64_t head = static_cast<uint64_t>(inst.op) | static_cast<uint64_t>(inst.type) << 16 |
                          static_cast<uint64_t>(inst.level) << 24 |
                          static_cast<uint64_t>(inst.extra) << 32;
    const uint64_t args = inst.arg[0] | static_cast<uint64_t>(inst.arg[1]) << 32;
    const uint64_t more_args = inst.arg[2] | static_cast<uint64_t>(inst.arg[3]) << 32;
    uint64_t h = head * 0x9E3779B97F4A7C15U + args * 0xC2B2AE3D27D4EB4FU +
                 more_args * 0x165667B19E3779F9U +
                 std::rotl(std::bit_cast<uint64_t>(inst.value), 32) * 0xD6E8FEB86659FD93U;
    h = (h ^ h >> 32) * 0xFF51AFD7ED558CCDU;
    return h ^ h >> 29;
}

// Poison where there is none: operands of loops and calls stand in a list.
Id newest_operand(const Inst& inst) {
    if (inst.op == Op::loop_ || inst.op == Op::call_) return poison;
    return std::max(std::max(inst.arg[0], inst.arg[1]), std::max(inst.arg[2], inst.arg[3]));
}

}  // namespace

// A quarter of what there is are leaves, about, and half of the slots are taken at most.
InternTable::InternTable(size_t expected)
    : slots_(std::bit_ceil(std::max<size_t>(expected / 2, 128)), poison) {
    readers_.reserve(expected);
}

Id InternTable::intern(const Inst& wanted, std::vector<Inst>& inst) {
    if (const Id operand = newest_operand(wanted)) {
        int looks = 0;
        for (Id id = readers_[operand].newest; id != poison; id = readers_[id].next, ++looks)
            if (identical(inst[id], wanted)) return id;
        if (looks < longest_chain) {
            const Id id = append(wanted, inst);
            readers_[id].next = std::exchange(readers_[operand].newest, id);
            return id;
        }
    }
    Id& slot = slot_of(wanted, inst);
    if (slot != poison) return slot;
    const Id id = slot = append(wanted, inst);
    if (++taken_ * 2 > slots_.size()) grow(inst);
    return id;
}

Id InternTable::append(const Inst& added, std::vector<Inst>& inst) {
    inst.push_back(added);
    readers_.push_back({});
    return static_cast<Id>(inst.size() - 1);
}

// That of an equal one, or the free one for it.
Id& InternTable::slot_of(const Inst& wanted, const std::vector<Inst>& inst) {
    const size_t mask = slots_.size() - 1;
    size_t slot = hash_of(wanted) & mask;
    while (slots_[slot] != poison && !identical(inst[slots_[slot]], wanted))
        slot = (slot + 1) & mask;
    return slots_[slot];
}

void InternTable::grow(const std::vector<Inst>& inst) {
    const std::vector<Id> before =
        std::exchange(slots_, std::vector<Id>(slots_.size() * 2, poison));
    for (const Id id : before)
        if (id != poison) slot_of(inst[id], inst) = id;
}

}  // namespace wrinkle

#include "ir/intern_table.h"

#include <algorithm>
#include <utility>

namespace wrinkle {
namespace {

constexpr int longest_chain = 8;

// Multilinear, then mixed downwards: literals differ in the highest bits of their value alone, and
// a slot is taken from the lowest bits.
uint64_t hash_of(const PackedInst& p) {
    uint64_t h = p.head * 0x9E3779B97F4A7C15U + p.args * 0xC2B2AE3D27D4EB4FU +
                 p.more_args * 0x165667B19E3779F9U + std::rotl(p.value, 32) * 0xD6E8FEB86659FD93U;
    h = (h ^ h >> 32) * 0xFF51AFD7ED558CCDU;
    return h ^ h >> 29;
}

// Half of the table is taken at most.
bool is_full(size_t taken, size_t slots) {
    return taken * 2 > slots;
}

// Poison where there is none: operands of loops and calls stand in a list.
Id newest_operand(const PackedInst& inst) {
    const Op op = unpacked(inst).op;
    if (op == Op::loop_ || op == Op::call_) return poison;
    const auto newest = [](uint64_t pair) {
        return std::max(static_cast<Id>(pair), static_cast<Id>(pair >> 32));
    };
    return std::max(newest(inst.args), newest(inst.more_args));
}

}  // namespace

// A quarter of what there is are leaves, about.
InternTable::InternTable(size_t expected)
    : slots_(std::bit_ceil(std::max<size_t>(expected / 2, 128)), poison) {
    readers_.reserve(expected);
}

Id InternTable::find(const PackedInst& wanted, const std::vector<Inst>& inst) const {
    if (const Id operand = newest_operand(wanted)) {
        int looks = 0;
        for (Id id = readers_[operand].newest; id != poison; id = readers_[id].next, ++looks)
            if (packed(inst[id]) == wanted) return id;
        if (looks < longest_chain) return poison;
    }
    const size_t mask = slots_.size() - 1;
    for (size_t slot = hash_of(wanted) & mask; slots_[slot] != poison; slot = (slot + 1) & mask)
        if (packed(inst[slots_[slot]]) == wanted) return slots_[slot];
    return poison;
}

void InternTable::add(const PackedInst& added, const std::vector<Inst>& inst) {
    const auto id = static_cast<Id>(inst.size() - 1);
    readers_.resize(inst.size());
    if (const Id operand = newest_operand(added)) {
        int length = 0;
        for (Id reader = readers_[operand].newest; reader != poison; reader = readers_[reader].next)
            ++length;
        if (length < longest_chain) {
            readers_[id].next = readers_[operand].newest;
            readers_[operand].newest = id;
            return;
        }
    }
    add_to_slots(added, id);
    if (is_full(++taken_, slots_.size())) grow(inst);
}

void InternTable::add_to_slots(const PackedInst& added, Id id) {
    const size_t mask = slots_.size() - 1;
    size_t slot = hash_of(added) & mask;
    while (slots_[slot] != poison)
        slot = (slot + 1) & mask;
    slots_[slot] = id;
}

void InternTable::grow(const std::vector<Inst>& inst) {
    const std::vector<Id> before =
        std::exchange(slots_, std::vector<Id>(slots_.size() * 2, poison));
    for (const Id id : before)
        if (id != poison) add_to_slots(packed(inst[id]), id);
}

}  // namespace wrinkle

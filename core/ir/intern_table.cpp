#include "ir/intern_table.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace wrinkle {
namespace {

constexpr int max_chain = 8;

// The members of an instruction; it has no padding. Literals are compared by their bits.
using Words = std::array<uint64_t, 4>;

Words words_of(const Inst& inst) {
    return std::bit_cast<Words>(inst);
}

// A sum of products, mixed towards the low bits: short literals differ in high bits only.
uint64_t hash_of(const Words& words) {
    uint64_t h = words[0] * 0x9E3779B97F4A7C15U + words[1] * 0xC2B2AE3D27D4EB4FU +
                 words[2] * 0xD2B74407B1CE6E93U + std::rotl(words[3], 32) * 0xD6E8FEB86659FD93U;
    h = (h ^ h >> 32) * 0xFF51AFD7ED558CCDU;
    return h ^ h >> 29;
}

// Returns no_id for leaves, and for loops and calls, which have their operands in a list.
Id newest_operand(const Inst& inst) {
    if (inst.op == Op::loop_ || inst.op == Op::call_) return no_id;
    return std::max(std::max(inst.arg[0], inst.arg[1]), std::max(inst.arg[2], inst.arg[3]));
}

}  // namespace

// About a sixteenth of the instructions are distinct leaves, and at most half of the slots are
// used.
void InternTable::reserve(size_t expected) {
    slots_.assign(std::bit_ceil(std::max<size_t>(expected / 8, 128)), no_id);
}

Id& InternTable::find(const Inst& wanted, const std::vector<Inst>& inst) {
    const Id operand = newest_operand(wanted);
    if (operand == no_id) return find_in_table(wanted, inst);
    if (inst.size() > users_.size()) users_.resize(inst.capacity());
    const Words words = words_of(wanted);
    Id* slot = &users_[operand].first;
    for (int steps = 0; *slot != no_id && words_of(inst[*slot]) != words; ++steps) {
        if (steps == max_chain) return find_in_table(wanted, inst);
        slot = &users_[*slot].next;
    }
    return *slot;
}

Id& InternTable::find_in_table(const Inst& wanted, const std::vector<Inst>& inst) {
    Id& slot = slot_of(wanted, inst);
    if (slot != no_id || ++taken_ * 2 <= slots_.size()) return slot;
    grow(inst);
    return slot_of(wanted, inst);
}

Id& InternTable::slot_of(const Inst& wanted, const std::vector<Inst>& inst) {
    const Words words = words_of(wanted);
    const size_t mask = slots_.size() - 1;
    size_t slot = hash_of(words) & mask;
    while (slots_[slot] != no_id && words_of(inst[slots_[slot]]) != words)
        slot = (slot + 1) & mask;
    return slots_[slot];
}

void InternTable::grow(const std::vector<Inst>& inst) {
    const std::vector<Id> before =
        std::exchange(slots_, std::vector<Id>(std::max<size_t>(slots_.size() * 2, 64), no_id));
    for (const Id id : before)
        if (id != no_id) slot_of(inst[id], inst) = id;
}

}  // namespace wrinkle

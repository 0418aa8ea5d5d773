#include "ir/intern_table.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace wrinkle {
namespace {

constexpr int longest_chain = 8;

// An instruction has no gaps between its members.
using Words = std::array<uint64_t, 4>;
static_assert(sizeof(Words) == sizeof(Inst));

bool identical(const Inst& a, const Inst& b) {
    return std::bit_cast<Words>(a) == std::bit_cast<Words>(b);
}

// Multilinear, then mixed downwards: literals differ in the highest bits of their value alone, and
// a slot is taken from the lowest bits.
uint64_t hash_of(const Inst& inst) {
    const Words words = std::bit_cast<Words>(inst);
    uint64_t h = words[0] * 0x9E3779B97F4A7C15U + words[1] * 0xC2B2AE3D27D4EB4FU +
                 words[2] * 0x165667B19E3779F9U + std::rotl(words[3], 32) * 0xD6E8FEB86659FD93U;
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
void InternTable::make_room(size_t expected) {
    slots_.assign(std::bit_ceil(std::max<size_t>(expected / 2, 128)), poison);
    readers_.reserve(expected);
}

Id InternTable::intern(const Inst& wanted, std::vector<Inst>& inst) {
    Id& place = place_of(wanted, inst);
    if (place != poison) return place;
    const auto added = place = static_cast<Id>(inst.size());
    inst.push_back(wanted);
    readers_.push_back({});
    return added;
}

// Where an equal one is named, or else, poison so far, this one is to be.
Id& InternTable::place_of(const Inst& wanted, const std::vector<Inst>& inst) {
    if (const Id operand = newest_operand(wanted)) {
        Id* place = &readers_[operand].first;
        for (int looks = 0; looks < longest_chain; ++looks, place = &readers_[*place].next)
            if (*place == poison || identical(inst[*place], wanted)) return *place;
    }
    Id& slot = slot_of(wanted, inst);
    if (slot != poison || ++taken_ * 2 <= slots_.size()) return slot;
    grow(inst);
    return slot_of(wanted, inst);
}

Id& InternTable::slot_of(const Inst& wanted, const std::vector<Inst>& inst) {
    const size_t mask = slots_.size() - 1;
    size_t slot = hash_of(wanted) & mask;
    while (slots_[slot] != poison && !identical(inst[slots_[slot]], wanted))
        slot = (slot + 1) & mask;
    return slots_[slot];
}

void InternTable::grow(const std::vector<Inst>& inst) {
    const std::vector<Id> before =
        std::exchange(slots_, std::vector<Id>(std::max<size_t>(slots_.size() * 2, 64), poison));
    for (const Id id : before)
        if (id != poison) slot_of(inst[id], inst) = id;
}

}  // namespace wrinkle

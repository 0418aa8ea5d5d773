#include "ir/intern_table.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace wrinkle {
namespace {

constexpr int max_chain = 8;

uint64_t bits_of(double value) {
    return std::bit_cast<uint64_t>(value);
}

// Compares member by member: the members of `a` were just written one by one, and a load of several
// members at once would wait for these stores.
bool identical(const Inst& a, const Inst& b) {
    return a.arg[0] == b.arg[0] && a.op == b.op && a.arg[1] == b.arg[1] && a.extra == b.extra &&
           bits_of(a.value) == bits_of(b.value) && a.type == b.type && a.arg[2] == b.arg[2] &&
           a.arg[3] == b.arg[3] && a.level == b.level;
}

// A sum of products, mixed towards the low bits: short literals differ in high bits only.
uint64_t hash_of(const Inst& inst) {
    uint64_t h = static_cast<uint64_t>(inst.op) * 0x9E3779B97F4A7C15U +
                 static_cast<uint64_t>(inst.type) * 0x8CB92BA72F3D8DD7U +
                 inst.level * 0xABC98388FB8FAC03U + inst.extra * 0xD2B74407B1CE6E93U +
                 inst.arg[0] * 0xC2B2AE3D27D4EB4FU + inst.arg[1] * 0xA0761D6478BD642FU +
                 inst.arg[2] * 0x165667B19E3779F9U + inst.arg[3] * 0xE7037ED1A0B428DBU +
                 std::rotl(bits_of(inst.value), 32) * 0xD6E8FEB86659FD93U;
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
    Id* slot = &users_[operand].first;
    for (int steps = 0; *slot != no_id && !identical(inst[*slot], wanted); ++steps) {
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
    const size_t mask = slots_.size() - 1;
    size_t slot = hash_of(wanted) & mask;
    while (slots_[slot] != no_id && !identical(inst[slots_[slot]], wanted))
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

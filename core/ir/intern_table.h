// Hash consing: finds the instruction of a module that equals a given one.
//
// Instructions with operands are stored in chains, one per newest operand (the greatest id): a
// chain is short and was used recently, so it is in the cache. Leaves, loops, calls and the ends of
// long chains are in a hash table with open addressing, load factor at most 1/2. O(1) expected,
// O(n) if all hashes collide. A single hash table for all instructions takes 1.7 times as long to
// compile 10,000 layers.
#pragma once

#include <vector>

#include "ir/inst.h"

namespace wrinkle {

class InternTable {
public:
    void reserve(size_t expected);  // expected number of instructions; before the first find()

    // Returns the slot of the instruction among `inst` that equals `wanted`. If the slot holds
    // no_id there is none, and the caller appends the instruction and writes its Id to the slot.
    // Literals are compared by their bits: -0 and 0 are different.
    Id& find(const Inst& wanted, const std::vector<Inst>& inst);

private:
    struct Users {
        Id first = no_id;  // first instruction with this one as its newest operand
        Id next = no_id;   // next in the chain that contains this one
    };
    Id& find_in_table(const Inst& wanted, const std::vector<Inst>& inst);
    Id& slot_of(const Inst& wanted, const std::vector<Inst>& inst);
    void grow(const std::vector<Inst>& inst);

    std::vector<Users> users_;                // by Id
    std::vector<Id> slots_ = {no_id, no_id};  // no_id: free
    size_t taken_ = 0;
};

}  // namespace wrinkle

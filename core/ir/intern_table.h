// Which instruction of a module is equal to one at hand.
//
// An instruction is found by the newest of its operands: a few that read a value stand in a chain
// of that value. Mostly it was made just now, and its chain with it, so what is looked at is in the
// nearest cache, however large the module. Leaves, loops, calls and the many readers of one value
// stand in a hash table.
#pragma once

#include <vector>

#include "ir/inst.h"

namespace wrinkle {

class InternTable {
public:
    void make_room(size_t expected);  // for so many instructions; before the first

    // Where the equal one among `inst` is named; where there is none, poison: its name is to be
    // written there when it is appended to them. Literals are told apart by their bits: -0 and 0
    // are two.
    Id& place_of(const Inst& wanted, const std::vector<Inst>& inst);
    Id& place_of_leaf(const Inst& wanted, const std::vector<Inst>& inst);  // without operands

private:
    // Of those whose newest operand is this one; and in the chain that it stands in itself.
    struct Readers {
        Id first = poison;
        Id next = poison;
    };
    Id& slot_of(const Inst& wanted, const std::vector<Inst>& inst);
    void grow(const std::vector<Inst>& inst);

    std::vector<Readers> readers_;              // by Id
    std::vector<Id> slots_ = {poison, poison};  // open addressing; poison is free
    size_t taken_ = 0;
};

}  // namespace wrinkle

// A call of a function from a graph that is being lowered: its arguments, as the function's body
// reads them. Internal to core/lower.
//
// Most inputs of the body are leaves (ir/open_input.h). Arguments that would lose their meaning as
// a number are bound unchanged: an image, a surface input or the surface's normal, a flat gradient.
// So a function is specialised for each kind of arguments, identified by `key`: the facts about the
// leaves are part of it, their values are not.
#pragma once

#include <string>
#include <vector>

#include "ir/value_analysis.h"
#include "lower/lowering.h"

namespace wrinkle {

struct CallInputs {
    std::vector<BoundInput> bound;  // by input of the file; add_leaves() sets the leaves
    std::vector<OpenInput> leaves;
    std::vector<uint32_t> leaf_of;  // by leaf: its input
    std::vector<Id> arguments;      // by leaf
    std::string key;
};

// Precondition: the nodes that the node's inputs read have been built.
CallInputs call_inputs(Lowering& caller, uint32_t node, const std::vector<bool>& needed,
                       ValueAnalysis& facts);

// Adds the leaves as inputs of a body; returns the index of the first in Module::open_inputs.
uint32_t add_leaves(Module& module, CallInputs& inputs);

}  // namespace wrinkle

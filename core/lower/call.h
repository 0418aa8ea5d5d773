// A call of a function from a graph that is being lowered: its arguments, as the function's body
// sees them. For core/lower alone.
//
// Most inputs of the body are leaves (ir/open_input.h). What would lose its meaning as a number
// stays what it is instead: an image, a surface input or the surface's normal as they are, a
// gradient that is flat. So a function has a variant for each kind of arguments, told apart by
// `key`: what is said of the leaves counts, their values do not.
#pragma once

#include <string>
#include <vector>

#include "ir/value_facts.h"
#include "lower/lowering.h"

namespace wrinkle {

struct CallInputs {
    std::vector<BoundInput> bound;  // by input of the file; of leaves yet to be filled in
    std::vector<OpenInput> leaves;
    std::vector<uint32_t> leaf_of;  // of each leaf: the input that it is
    std::vector<Id> arguments;      // of the leaves
    std::string key;
};

// What the node's inputs hold must have been built.
CallInputs call_inputs(Lowering& caller, uint32_t node, const std::vector<bool>& needed,
                       ValueFacts& facts);

// The leaves as inputs of a body. The index of the first.
uint32_t add_leaves(Module& module, CallInputs& inputs);

}  // namespace wrinkle

// Nodes of MaterialX for ops of the expression language.
#pragma once

#include <string_view>
#include <vector>

#include "ir/op.h"

namespace wrinkle {

// An op that is one node: operand i is inputs[i]. The caller writes in1 = 0 for neg_ and in2 = -0.5
// for inversesqrt_.
struct MtlxCall {
    Op op;
    const char* category;
    std::vector<const char*> inputs;
};
const MtlxCall* mtlx_call(Op op);  // null: none

// A comparison as ifgreater, ifgreatereq or ifequal: category(value1, value2) ? in1 : in2.
struct MtlxComparison {
    Op op;
    const char* category;
    bool swaps_operands, swaps_results;
};
const MtlxComparison* mtlx_comparison(Op op);  // null: none

// The node of an input of the surface; `input_extra` is Inst::extra of an input_ op.
struct MtlxSurface {
    std::string_view category;  // "" if there is none
    std::string_view type;
    int index;  // number of the uv set; -1: not a uv set
};
MtlxSurface mtlx_surface(uint32_t input_extra);

}  // namespace wrinkle

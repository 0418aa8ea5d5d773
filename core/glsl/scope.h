// One function or loop body before it is text: the values it computes, which of them become
// temporaries, and their order.
//
// A value becomes a temporary when it stands at a node's output, is read more than once or inside a
// loop, or when folding it into its one reader would make that line too wide or too deep; a value
// with implicit derivatives also when its reader may skip it. Temporaries of one node stand
// together as far as dependencies allow, else in the order of a walk from the results.
#pragma once

#include <span>
#include <vector>

#include "glsl/names.h"
#include "glsl/plan.h"

namespace wrinkle {

// What is known of a value in the scope at hand.
struct ValueState {
    uint32_t epoch = 0;          // of the scope that it belongs to
    uint32_t uses = 0;           // how often it is read
    uint32_t place = 0;          // among the scope's statements
    uint32_t name_begin = 0;     // of a temporary, once it is written
    uint32_t width = 0;          // where it is read: of its text, about; of a temporary's name
    uint8_t depth = 1;           // of its text, in operations
    bool ordered : 1 = false;    // it is in the scope's order
    bool root : 1 = false;       // a result of the scope
    bool statement : 1 = false;  // a temporary; also loops and calls with several results
    bool captured : 1 = false;   // by a loop
    bool implicit : 1 = false;   // its folded text takes implicit derivatives
    bool shared : 1 = false;     // read by temporaries of the surface point only

    Name name() const { return {name_begin, width}; }
    void call(Name name) {
        name_begin = name.begin;
        width = name.length;
    }
};

// The values of a module; a scope overwrites the states of what it computes, and of nothing else.
struct Values {
    explicit Values(const Plan& plan)
        : state(plan.module().size()), group_numbers(plan.module().nodes.size() + 1) {}
    std::vector<ValueState> state;        // by Id
    std::vector<uint32_t> group_numbers;  // zeros: memory of schedule()
    uint32_t epoch = 0;
    bool anonymous = false;  // a helper function, shared by nodes: no node's names or comments
};

struct Scope {
    uint32_t epoch = 0;
    std::vector<Id> order;  // post-order from the roots, leaves left out
    size_t first_part = 0;  // how many of these the first root needs
};

// `level` 0: a function's body, else a loop's: values of lower levels stand outside.
Scope collect(const Plan& plan, Values& values, std::span<const Id> roots, int level);

// Decides what is a temporary.
void decide(const Plan& plan, Values& values, const Scope& scope, std::span<const Id> roots);

// The statements among `part` of the scope's order, as they are to be written.
std::vector<Id> schedule(const Plan& plan, Values& values, const Scope& scope,
                         std::span<const Id> part);

// Whose comment a statement stands under: a node, or the surface point shared by all.
inline constexpr uint32_t surface_group = ~1U;
uint32_t group_of(const Plan& plan, const Values& values, Id id);

// The name that a value would like: of its node and port, or of the surface point.
WantedName wanted_name(const Plan& plan, const Values& values, Id id);

}  // namespace wrinkle

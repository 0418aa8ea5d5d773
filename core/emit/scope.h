// Statement selection for one function or loop body: the values it computes, those that become
// temporaries, and their order. A value becomes a temporary if
//   - it is a node's output or, in a function, has a name of its author;
//   - it has several users, or is captured by a loop;
//   - folding it into its only user would make that line too wide or too deep; or
//   - it takes implicit derivatives and its user may skip its evaluation.
// Temporaries of one node are adjacent as far as dependencies allow, else in post-order from the
// results.
#pragma once

#include <span>
#include <vector>

#include "emit/emit_analysis.h"
#include "emit/names.h"

namespace wrinkle {

// State of a value in the current scope.
struct ValueState {
    uint32_t epoch = 0;          // identifies the scope that the value belongs to
    uint32_t uses = 0;           // within the scope
    uint32_t place = 0;          // index among the scope's statements
    uint32_t width = 0;          // estimated characters at a use: expression or temporary's name
    std::string_view name;       // name of a temporary, once it is written
    uint8_t depth = 1;           // nested operations in its text
    bool ordered : 1 = false;    // in Scope::order
    bool root : 1 = false;       // a result of the scope
    bool statement : 1 = false;  // a temporary, a loop, or a call with several results
    bool captured : 1 = false;   // captured by a loop
    bool implicit : 1 = false;   // its folded text takes implicit derivatives
    bool shared : 1 = false;     // used only by values of surface_group
};

// State of all values of a module; collect() resets only the states of values in its scope.
struct Values {
    Values(const EmitAnalysis& analysis, const Symbols& names)
        : symbols(names),
          state(analysis.module().size()),
          group_numbers(analysis.module().nodes.size() + 1) {}
    const Symbols& symbols;
    std::vector<ValueState> state;        // by Id
    std::vector<uint32_t> group_numbers;  // scratch of schedule(); all zero between calls
    uint32_t epoch = 0;
    bool anonymous = false;  // in a helper function, which nodes share: no node names or comments
};

struct Scope {
    uint32_t epoch = 0;
    std::vector<Id> order;  // post-order from the roots, without leaves
    // Length of the prefix that roots[0] needs; in a loop body that is the loop condition.
    size_t first_part = 0;
};

// Returns the values that `roots` depend on. `level` is 0 for a function's body, else the loop's
// level; values of lower levels are computed outside the loop and are not in its scope.
Scope collect(const EmitAnalysis& analysis, Values& values, std::span<const Id> roots, int level);

// Sets ValueState::statement for the temporaries of the scope.
void decide(const EmitAnalysis& analysis, Values& values, const Scope& scope,
            std::span<const Id> roots);

// Returns the statements in `part` of the scope's order, in the order of emission.
std::vector<Id> schedule(const EmitAnalysis& analysis, Values& values, const Scope& scope,
                         std::span<const Id> part);

// Group of a statement, by which statements are ordered and commented: a node's index, or
// surface_group for the surface point, which all nodes share.
inline constexpr uint32_t surface_group = ~1U;
uint32_t group_of(const EmitAnalysis& analysis, const Values& values, Id id);

// Returns the name hint of a value: its node and port, or the surface point.
NameHint name_hint(const EmitAnalysis& analysis, const Values& values, Id id);

}  // namespace wrinkle

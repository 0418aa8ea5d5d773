// Makes a finished module smaller without changing a number. Part of expand().
//
//   join_calls   Functions that are called with equal arguments and share work become one function
//                with the results of all, in every call; results that no call uses are dropped. A
//                value and its slope then come from one call.
//   join_loops   Loops that advance the same state become one loop, so that all directions of a
//                derivative are computed with the value; members that nothing reads are dropped.
//   pack         Scalars of one form that are the components of a vector become one vector
//                expression (superword-level parallelism, Larsen and Amarasinghe 2000).
#pragma once

#include "ir/module.h"

namespace wrinkle {

Module compact(Module module);

// Internal to the pass.
void join_calls(Module& module);
std::vector<Id> join_loops(Module& module, std::vector<Id> roots);  // in one scope
Module pack(Module module);

}  // namespace wrinkle

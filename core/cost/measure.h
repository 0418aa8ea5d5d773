// A module's cost, in one call: written as functions of GLSL 4.50, compiled, optimised as by
// `spirv-opt -O`, counted. What `wrinkle compile --cost` prints and what the editor's cards show.
//
// Everything is inlined, so it takes milliseconds for a material of a few nodes and seconds for one
// of thousands. Needs the module of compilers (spirv/spirv.h); safe on any number of threads.
#pragma once

#include <optional>
#include <string>

#include "cost/report.h"
#include "ir/module.h"

namespace wrinkle {

// Of an expanded module, as emit() takes it. Nothing, with the reason in `why`, when the module of
// compilers is missing or refuses the text.
std::optional<CostReport> measure_cost(const Module& module, Differentials differentials,
                                       std::string& why);

}  // namespace wrinkle

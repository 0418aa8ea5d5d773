// Measures the cost of a module: emits GLSL 4.50 functions, compiles them, optimises as
// `spirv-opt -O` and counts. Shown by `wrinkle compile --cost` and on the editor's node cards.
//
// All functions are inlined, so it takes milliseconds for a material of a few nodes and seconds for
// one of thousands. Requires the compiler module (spirv/spirv.h). Thread-safe.
#pragma once

#include <optional>
#include <string>

#include "cost/report.h"
#include "ir/side_tables.h"

namespace wrinkle {

// `module` is expanded, as for emit(). Returns std::nullopt and sets `why` if the emitter reports a
// problem, or the compiler module is missing or rejects the source.
std::optional<CostReport> measure_cost(const Module& module, Differentials differentials,
                                       std::string& why);

}  // namespace wrinkle

// The cost of a material, in total and by node, counted in SPIR-V optimised by spirv-opt.
//
// Only the function form and its calls are counted: the members of its struct are interpolants,
// each output is written, without lighting or world transform. The figures are those of
// docs/cost.md and exclude any wrapper. An instruction belongs to the node of its source line; an
// instruction shared by several nodes belongs to one of them, or to none (the surface point).
// Instructions removed by the optimiser cost nothing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cost/spirv_count.h"
#include "glsl/emit.h"
#include "ir/side_tables.h"

namespace wrinkle {

struct NodeCost {
    std::string node;  // path
    ShaderCost cost;
    size_t texture_units = 0;  // images that it reads, possibly shared with other nodes
};

struct CostReport {
    ShaderCost total;
    std::vector<NodeCost> nodes;  // with a cost, in decreasing order of alu
    ShaderCost shared;            // surface point and instructions without a line
    size_t texture_units = 0;     // total
};
// `shader` is the function form from which counted_shader() was made; `count` is its count.
CostReport cost_report(const Shader& shader, const SpirvCount& count);

// Measures the cost of an expanded module: emits GLSL 4.50 functions, compiles them, optimises as
// `spirv-opt -O` and counts. All functions are inlined, so it takes milliseconds for a material of
// a few nodes and seconds for one of thousands. Returns std::nullopt and sets `why` if the emitter
// reports a problem, or the compiler module (spirv/spirv.h) is missing or rejects the source.
// Thread-safe.
std::optional<CostReport> measure_cost(const Module& module, Differentials differentials,
                                       std::string& why);

// Human-readable report: totals, then one line per node.
//   ALU div reads derivs units  node
std::string to_text(const CostReport& report);

// {"total": {"alu", "transcendental", "divisions", "texture_reads", "texture_queries",
//  "derivatives", "derivative_numbers", "branches", "loops", "texture_units"},
//  "nodes": [{"node", and as above}], "surface_point": {as above, no units}}, on several lines.
std::string to_json(const CostReport& report);

}  // namespace wrinkle

// The cost of a material, in total and by node, counted in SPIR-V optimised by spirv-opt.
//
// Counts the code of the function form in a minimal fragment shader (cost/counted_shader.h), which
// has no lighting or world transform; docs/cost.md defines the figures. An instruction belongs to
// the node of its source line; one that several nodes share belongs to one of them, or to none and
// is then part of "the surface point". Instructions that the optimiser removes cost nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cost/spirv_count.h"
#include "emit/emit.h"
#include "ir/side_tables.h"

namespace wrinkle {

struct NodeCost {
    std::string node;  // path
    ShaderCost cost;
    size_t texture_units = 0;  // images that it reads, possibly shared with other nodes
};

struct CostReport {
    ShaderCost total;
    ShaderCost once;              // total with loop bodies counted once
    std::vector<NodeCost> nodes;  // with a cost, in decreasing order of alu
    ShaderCost shared;            // surface point and instructions without a line
    size_t texture_units = 0;     // total
};
// `count` is the count of the compiled counted_shader(shader).
CostReport cost_report(const Shader& shader, const SpirvCount& count);

// Measures the cost of an expanded module: emits GLSL 4.50 functions, compiles them, optimises as
// `spirv-opt -O` and counts. All functions are inlined, so it takes milliseconds for a material of
// a few nodes and seconds for one of thousands. Returns std::nullopt and sets `why` if the emitter
// reports a problem, or the compiler module (spirv/spirv.h) is missing or rejects the source.
// Thread-safe.
std::optional<CostReport> measure_cost(const Module& module, Differentials differentials,
                                       std::string& why);

// Numbers of the total by the names of to_json(): "alu", ..., "texture_units".
struct NamedCount {
    const char* name;
    uint64_t count;
};
std::vector<NamedCount> named_counts(const CostReport& report);

// Human-readable report: totals, with loop bodies once if that differs, then one line per node.
//   ALU div reads derivs units  node
std::string to_text(const CostReport& report);

// {"total": {"alu", "transcendental", "divisions", "texture_reads", "texture_queries",
//  "derivatives", "derivative_numbers", "branches", "loops", "texture_units"},
//  "loop_bodies_once": {as above, no units},
//  "nodes": [{"node", and as above}], "surface_point": {as above, no units}}, on several lines.
std::string to_json(const CostReport& report);

}  // namespace wrinkle

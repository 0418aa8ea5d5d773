// What a material costs, in total and by node, from SPIR-V that spirv-opt has left of it.
//
// What is counted is the function form with its calls alone: the members of its struct are
// interpolants, each output is written, nothing is lit and nothing is turned into the world. So the
// figures are those of docs/cost.md and no wrapper's. An instruction belongs to the node whose line
// of the text it came from; what several nodes need stands in the line of one of them, or of none,
// the surface point's. What the optimiser removed costs nothing.
#pragma once

#include <string>
#include <vector>

#include "cost/spirv_count.h"
#include "glsl/emit.h"

namespace wrinkle {

struct NodeCost {
    std::string node;  // path
    ShaderCost cost;
    size_t texture_units = 0;  // of the images that it reads; others may read them too
};

struct CostReport {
    ShaderCost total;
    std::vector<NodeCost> nodes;  // that cost something, the most numbers first
    ShaderCost shared;            // of the surface point, and of no line
    size_t texture_units = 0;     // in all
};
// Of the function form that counted_shader() was made from.
CostReport cost_report(const Shader& shader, const SpirvCount& count);

// The report for people: totals, then a line for each node.
//   ALU div reads derivs units  node
std::string to_text(const CostReport& report);

// {"total": {"alu", "transcendental", "divisions", "texture_reads", "texture_queries",
//  "derivatives", "derivative_numbers", "branches", "loops", "texture_units"},
//  "nodes": [{"node", and as above}], "surface_point": {as above, no units}}, on several lines.
std::string to_json(const CostReport& report);

}  // namespace wrinkle

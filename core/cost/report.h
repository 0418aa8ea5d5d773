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

// Units for images that each target gives a fragment shader at least: GL_MAX_TEXTURE_IMAGE_UNITS of
// OpenGL 3.3 and ES 3.0, maxPerStageDescriptorSampledImages of Vulkan, sampler states of shader
// model 5.0 and of Metal.
inline constexpr size_t guaranteed_texture_units = 16;

// A fragment shader of GLSL 4.50 around the function form.
struct CountedShader {
    std::string text;
    uint32_t lines_before = 0;  // the function form's
};
CountedShader counted_shader(const Shader& shader);

struct NodeCost {
    uint32_t node = 0;  // Module::nodes
    ShaderCost cost;
};

struct CostReport {
    ShaderCost total;
    std::vector<NodeCost> nodes;  // that cost something, the most numbers first
    ShaderCost shared;            // of the surface point, and of no line
    size_t texture_units = 0;
};
CostReport cost_report(const Shader& shader, const CountedShader& counted, const SpirvCount& count);

// The report for people: totals, then a line for each node.
//   numbers div reads derivs  node
std::string to_text(const CostReport& report, const Reflection& reflection);

// What is wrong with the number of images, naming them; "" when every target has units enough.
std::string texture_unit_problem(const Reflection& reflection);

}  // namespace wrinkle

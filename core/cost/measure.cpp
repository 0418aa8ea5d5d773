#include "cost/measure.h"

#include "cost/counted_shader.h"
#include "spirv/spirv.h"

namespace wrinkle {
namespace {

std::string first_line_of(const std::string& log) {
    return log.substr(0, log.find('\n'));
}

}  // namespace

std::optional<CostReport> measure_cost(const Module& module, Differentials differentials,
                                       std::string& why) {
    EmitOptions options;
    options.differentials = differentials;
    options.target = find_target("glsl450");
    const Shader shader = emit(module, options);
    if (!shader.problems.empty()) {
        why = shader.problems.front().message;
        return {};
    }
    const auto words =
        compile_to_spirv(counted_shader(shader), ShaderStage::fragment, Lines::keep, why);
    const auto small = words ? optimised(*words, Inlining::all, why) : std::nullopt;
    const auto count = small ? count_spirv(*small, why) : std::nullopt;
    if (count) return cost_report(shader, *count);
    why = first_line_of(why);
    return {};
}

}  // namespace wrinkle

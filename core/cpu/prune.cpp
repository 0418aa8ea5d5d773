// Two passes of compile_program() between flattening and register allocation: hoisting of constants
// into preset registers, and removal of unused steps and sampled channels. Linear in the steps.
#include <algorithm>

#include "cpu/flatten.h"

namespace wrinkle {
namespace {

// Sufficient for a small material. A preset register stays live for the complete program and so
// occupies a part of the L1 cache.
constexpr size_t max_presets = 24;

// Returns the number of channels to sample, so that all used ones are included: 1, 3 or 4.
uint8_t channels_of(const CpuInst& sample, const std::vector<bool>& used) {
    uint8_t channels = 1;
    for (uint8_t c = 1; c < 4; ++c)
        if (used[sample.out[c]]) channels = c == 3 ? 4 : 3;
    return channels;
}

}  // namespace

void hoist_constants(Program& program) {
    if (program.constants.size() > max_presets) return;
    const auto is_constant = [](const CpuInst& step) {
        return step.kind == CpuInst::Kind::constant;
    };
    for (const CpuInst& step : program.steps)
        if (is_constant(step))
            program.presets.push_back({program.constants[step.extra], step.type, step.out[0]});
    remove_steps(program.steps, is_constant);
}

void remove_unused(Program& program, size_t registers) {
    std::vector<bool> used(registers, false);
    const auto use_operands = [&](const CpuInst& step) {
        for (uint32_t i = 0; i < step.count; ++i)
            used[step.in[i]] = true;
    };
    for (const Program::Output& output : program.outputs)
        for (const uint32_t reg : output.regs)
            used[reg] = true;
    // Values that a loop moves or tests are read again by earlier steps, in the next iteration.
    const auto is_pure = [](const CpuInst& step) { return step.kind < CpuInst::Kind::move; };
    for (const CpuInst& step : program.steps)
        if (!is_pure(step)) use_operands(step);
    for (size_t s = program.steps.size(); s-- > 0;) {
        CpuInst& step = program.steps[s];
        if (!is_pure(step)) continue;
        const auto outputs = std::span(step.out).first(step.outputs);
        if (std::ranges::none_of(outputs, [&](uint32_t reg) { return used[reg]; })) {
            step.outputs = 0;
            continue;
        }
        if (step.kind == CpuInst::Kind::sample) step.channels = channels_of(step, used);
        use_operands(step);
    }
    remove_steps(program.steps,
                 [&](const CpuInst& step) { return is_pure(step) && step.outputs == 0; });
}

}  // namespace wrinkle

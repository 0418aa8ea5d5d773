// Removal of unused steps and sampled channels; part of compile_program(). Linear in the steps.
#include <algorithm>

#include "cpu/flatten.h"

namespace wrinkle {
namespace {

// Returns the number of channels to sample, so that all used ones are included: 1, 3 or 4.
uint8_t channels_of(const CpuInst& sample, const std::vector<bool>& used) {
    uint8_t channels = 1;
    for (uint8_t c = 1; c < 4; ++c)
        if (used[sample.out[c]]) channels = c == 3 ? 4 : 3;
    return channels;
}

}  // namespace

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

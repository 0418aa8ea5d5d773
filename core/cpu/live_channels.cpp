// Two passes of compile_program() between flattening and register allocation: hoisting of constants
// into preset registers, and liveness of sampled channels and of steps that compute only a lod.
// Linear in the steps.
#include <algorithm>

#include "cpu/flatten.h"

namespace wrinkle {
namespace {

// Sufficient for a small material. A preset register stays live for the complete program and so
// occupies a part of the L1 cache.
constexpr size_t max_presets = 24;

// Use of a register: no_users, resource index + 1 if only the lod of that texture depends on it, or
// many_users for any other use.
constexpr uint32_t no_users = 0, many_users = ~0u;

// Returns the join of two uses, in the lattice no_users < one lod < many_users.
uint32_t both(uint32_t a, uint32_t b) {
    if (a == no_users || a == b) return b;
    return b == no_users ? a : many_users;
}

// Returns the number of channels to sample, so that all used ones are included: 1, 3 or 4.
uint8_t channels_of(const CpuInst& sample, const std::vector<uint32_t>& serves) {
    uint8_t channels = 1;
    for (uint8_t c = 1; c < 4; ++c)
        if (serves[sample.out[c]] != no_users) channels = c == 3 ? 4 : 3;
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

void mark_live_channels(Program& program, size_t registers) {
    std::vector<uint32_t> serves(registers, no_users);
    for (const Program::Output& output : program.outputs)
        for (const uint32_t reg : output.regs)
            serves[reg] = many_users;
    // Values that a loop moves or tests are read again by earlier steps, in the next iteration.
    const auto is_pure = [](const CpuInst& step) {
        return step.kind == CpuInst::Kind::op || step.kind == CpuInst::Kind::sample ||
               step.kind == CpuInst::Kind::size;
    };
    for (const CpuInst& step : program.steps)
        if (!is_pure(step))
            for (uint32_t i = 0; i < step.count; ++i)
                serves[step.in[i]] = many_users;
    for (size_t s = program.steps.size(); s-- > 0;) {
        CpuInst& step = program.steps[s];
        if (!is_pure(step)) continue;
        uint32_t whom = no_users;
        for (uint32_t i = 0; i < step.outputs; ++i)
            whom = both(whom, serves[step.out[i]]);
        if (step.kind == CpuInst::Kind::sample) step.channels = channels_of(step, serves);
        step.lod_of = whom == many_users ? 0 : whom;
        for (uint32_t i = 0; i < step.count; ++i) {
            const bool lod = step.kind == CpuInst::Kind::sample && i == 2;
            serves[step.in[i]] = both(serves[step.in[i]], lod ? step.extra + 1 : whom);
        }
    }
}

}  // namespace wrinkle

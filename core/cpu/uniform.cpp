// Finds the registers that have the same value at all points; part of compile_program().
#include <algorithm>

#include "cpu/flatten.h"
#include "cpu/kernel_table.h"

namespace wrinkle {
namespace {

// Starts with all registers uniform and marks those that vary, until no mark is added. The state of
// a loop varies if a later step of the body does, or the number of iterations.
class Varying {
public:
    Varying(const Program& program, size_t registers)
        : program_(program), uniform_(registers, true), loops_(program.steps.size(), false) {
        for (const Program::Input& input : program.inputs)
            mark(input.reg);
        for (const Program::Output& output : program.outputs)
            std::ranges::for_each(output.regs, [&](uint32_t reg) { mark(reg); });
    }

    std::vector<bool> run() {
        do {
            changed_ = false;
            for (uint32_t s = 0; s < program_.steps.size(); ++s)
                visit(s);
        } while (changed_);
        return std::move(uniform_);
    }

private:
    void mark(uint32_t reg) {
        changed_ = changed_ || uniform_[reg];
        uniform_[reg] = false;
    }
    bool any_varies(std::span<const uint32_t> registers) const {
        return std::ranges::any_of(registers, [&](uint32_t reg) { return !uniform_[reg]; });
    }
    void vary_loop(uint32_t begin) {
        changed_ = changed_ || !loops_[begin];
        loops_[begin] = true;
    }

    void visit(uint32_t s) {
        const CpuInst& step = program_.steps[s];
        const auto in = std::span(step.in).first(step.count);
        const auto out = std::span(step.out).first(step.outputs);
        switch (step.kind) {
            case CpuInst::Kind::loop_begin:
                if (!open_.empty() && loops_[open_.back()]) vary_loop(s);
                return open_.push_back(s);
            case CpuInst::Kind::loop_test:
                if (any_varies(in)) vary_loop(open_.back());
                return;
            case CpuInst::Kind::loop_end:
                return open_.pop_back();
            default:
                break;
        }
        const bool in_varying_loop =
            step.kind == CpuInst::Kind::masked_move && loops_[open_.back()];
        if (!has_kernel(step)) std::ranges::for_each(in, [&](uint32_t reg) { mark(reg); });
        if (in_varying_loop || !has_kernel(step) || any_varies(in) || any_varies(out))
            std::ranges::for_each(out, [&](uint32_t reg) { mark(reg); });
    }

    const Program& program_;
    std::vector<bool> uniform_;
    std::vector<bool> loops_;     // by loop_begin: the number of iterations varies
    std::vector<uint32_t> open_;  // loop_begin steps of the enclosing loops
    bool changed_ = false;
};

}  // namespace

std::vector<bool> uniform_registers(const Program& program, size_t registers) {
    return Varying(program, registers).run();
}

}  // namespace wrinkle

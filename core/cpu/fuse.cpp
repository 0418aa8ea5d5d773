// Fusion of steps that share a pass over memory; part of compile_program(). Sums of products become
// dots, and an op is paired with the only user of its value. Rounding is unchanged.
#include <algorithm>

#include "cpu/flatten.h"
#include "cpu/kernel_table.h"

namespace wrinkle {
namespace {

constexpr uint32_t no_step = ~0u;

class Fuser {
public:
    Fuser(Program& program, size_t registers)
        : steps_(program.steps),
          presets_(program.presets),
          def_(registers, no_step),
          user_(registers, no_step),
          uses_(registers, 0) {
        for (uint32_t s = 0; s < steps_.size(); ++s)
            for (uint32_t i = 0; i < steps_[s].count; ++i) {
                ++uses_[steps_[s].in[i]];
                user_[steps_[s].in[i]] = s;
            }
        for (const Program::Output& output : program.outputs)
            for (const uint32_t reg : output.regs)
                ++uses_[reg];
    }

    void run() {
        for (CpuInst& step : steps_)
            if (step.kind == CpuInst::Kind::sample) subtract(step);
        for (uint32_t s = 0; s < steps_.size(); ++s) {
            CpuInst& step = steps_[s];
            // Moves and loop steps are barriers: values defined before them may be read again.
            if (step.kind >= CpuInst::Kind::move) block_ = s;
            if (step.kind != CpuInst::Kind::op || step.type != Type::float_) continue;
            if (!depth(step) && !sum_of_products(step)) pair(step);
            if (step.outputs == 1) def_[step.out[0]] = s;
        }
        remove_steps(steps_, is_taken);
    }

private:
    // Returns the step that defines operand i if `user` is its only user and the step can be
    // moved down to `user`; otherwise null.
    CpuInst* single_use_producer(const CpuInst& user, uint32_t i) {
        const uint32_t def = def_[user.in[i]];
        if (def == no_step || def < block_ || uses_[user.in[i]] != 1) return nullptr;
        CpuInst& step = steps_[def];
        return step.lod_of == user.lod_of ? &step : nullptr;
    }

    static bool is(const CpuInst* step, Op op, uint8_t count) {
        return step && step->kind == CpuInst::Kind::op && step->op == op && step->count == count;
    }

    // Returns 1 + the index of the preset subtracted from all used channels of a sample; 0: none.
    uint32_t bias_of(const CpuInst& sample) const {
        uint32_t bias = 0;
        for (uint32_t c = 0; c < 4; ++c) {
            const uint32_t uses = uses_[sample.out[c]];
            if (uses == 0) continue;
            const uint32_t user = user_[sample.out[c]];
            if (uses > 1 || user == no_step) return 0;
            const CpuInst& step = steps_[user];
            if (!is(&step, Op::sub_, 2) || step.in[0] != sample.out[c]) return 0;
            const auto preset = std::find_if(
                presets_.begin(), presets_.end(),
                [&](const Program::ConstantRegister& each) { return each.reg == step.in[1]; });
            if (preset == presets_.end()) return 0;
            const auto number = static_cast<uint32_t>(preset - presets_.begin()) + 1;
            if (bias != 0 && bias != number) return 0;
            bias = number;
        }
        return bias;
    }

    // Folds the subtraction of one constant from all channels into the sample: the first operation
    // of normal map decoding.
    void subtract(CpuInst& sample) {
        sample.bias = bias_of(sample);
        for (uint32_t c = 0; c < 4 && sample.bias != 0; ++c) {
            if (uses_[sample.out[c]] == 0) continue;
            CpuInst& step = steps_[user_[sample.out[c]]];
            sample.out[c] = step.out[0];
            take(step);
        }
    }

    static bool is_size_max(const CpuInst* step) {
        return step && step->kind == CpuInst::Kind::pair && step->op == Op::abs_ &&
               step->second == Op::max_ && !step->swapped;
    }

    // Fuses the depth of a decoded normal, as ir/expand.h emits it; saves four passes.
    bool depth(CpuInst& step) {
        if (step.op != Op::max_) return false;
        CpuInst* inner = single_use_producer(step, 0);
        if (!is_size_max(inner)) return false;
        CpuInst* least = single_use_producer(*inner, 2);
        if (!is(least, Op::mul_, 2)) return false;
        CpuInst* greatest = single_use_producer(*least, 0);
        if (!is_size_max(greatest)) return false;
        CpuInst* size = single_use_producer(*greatest, 2);
        if (!is(size, Op::abs_, 1)) return false;
        step.kind = CpuInst::Kind::depth;
        step.in = {greatest->in[0], size->in[0], least->in[1], inner->in[0], step.in[1]};
        step.count = 5;
        for (CpuInst* taken : {inner, least, greatest, size})
            take(*taken);
        return true;
    }

    // Fuses a * b + c * d, or a dot of two components plus a * b, into a dot with the same order of
    // summation.
    bool sum_of_products(CpuInst& step) {
        if (step.op != Op::add_ || step.in[0] == step.in[1]) return false;
        CpuInst *a = single_use_producer(step, 0), *b = single_use_producer(step, 1);
        if (is(a, Op::mul_, 2) && is(b, Op::dot_, 4)) std::swap(a, b);
        if (!is(b, Op::mul_, 2)) return false;
        if (is(a, Op::mul_, 2)) {
            step.in = {a->in[0], b->in[0], a->in[1], b->in[1]};
            step.count = 4;
        } else if (is(a, Op::dot_, 4)) {
            step.in = {a->in[0], a->in[1], b->in[0], a->in[2], a->in[3], b->in[1]};
            step.count = 6;
        } else {
            return false;
        }
        step.op = Op::dot_;
        take(*a);
        take(*b);
        return true;
    }

    void pair(CpuInst& step) {
        if (step.count != 2 || !stands_in(second_ops, step.op) || step.in[0] == step.in[1]) return;
        for (const uint32_t i : {0u, 1u}) {
            CpuInst* first = single_use_producer(step, i);
            if (!first || first->kind != CpuInst::Kind::op || !stands_in(first_ops, first->op))
                continue;
            const uint32_t other = step.in[1 - i];
            step.second = step.op;
            step.swapped = i == 1;
            step.op = first->op;
            step.kind = CpuInst::Kind::pair;
            step.in = {first->in[0], first->count == 2 ? first->in[1] : first->in[0], other};
            step.count = 3;
            return take(*first);
        }
    }

    // Marks a step as fused into another one; run() removes it.
    static void take(CpuInst& step) {
        step.outputs = 0;
        step.count = 0;
        step.kind = CpuInst::Kind::op;
    }
    static bool is_taken(const CpuInst& step) {
        return step.kind == CpuInst::Kind::op && step.outputs == 0;
    }

    std::vector<CpuInst>& steps_;
    const std::vector<Program::ConstantRegister>& presets_;
    std::vector<uint32_t> def_;   // by register, like the following two
    std::vector<uint32_t> user_;  // the last user
    std::vector<uint32_t> uses_;
    uint32_t block_ = 0;  // steps before it are not fused
};

}  // namespace

void fuse_steps(Program& program, size_t registers) {
    Fuser(program, registers).run();
}

}  // namespace wrinkle

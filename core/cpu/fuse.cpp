// Fusion of steps that share a pass over memory; part of compile_program(). Sums of products become
// dots, and an op is paired with the only user of its value, in arithmetic of floats and of
// integers. Rounding is unchanged.
#include <algorithm>

#include "cpu/flatten.h"
#include "cpu/kernel_table.h"

namespace wrinkle {
namespace {

constexpr uint32_t no_step = ~0u;

class Fuser {
public:
    Fuser(Program& program, size_t registers)
        : steps_(program.steps), def_(registers, no_step), uses_(registers, 0) {
        for (const CpuInst& step : steps_)
            for (uint32_t i = 0; i < step.count; ++i)
                ++uses_[step.in[i]];
        for (const Program::Output& output : program.outputs)
            for (const uint32_t reg : output.regs)
                ++uses_[reg];
    }

    void run() {
        for (uint32_t s = 0; s < steps_.size(); ++s) {
            CpuInst& step = steps_[s];
            // Moves and loop steps are barriers: values defined before them may be read again.
            if (step.kind >= CpuInst::Kind::move) block_ = s;
            if (step.kind != CpuInst::Kind::op) continue;
            if (step.type == Type::uint_)
                pair(step, first_word_ops, second_word_ops);
            else if (step.type == Type::float_ && !sum_of_products(step))
                pair(step, first_ops, second_ops);
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
        return &steps_[def];
    }

    static bool is(const CpuInst* step, Op op, uint8_t count) {
        return step && step->kind == CpuInst::Kind::op && step->op == op && step->count == count;
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

    template <class First, class Second>
    void pair(CpuInst& step, const First& firsts, const Second& seconds) {
        if (step.count != 2 || !stands_in(seconds, step.op) || step.in[0] == step.in[1]) return;
        for (const uint32_t i : {0u, 1u}) {
            CpuInst* first = single_use_producer(step, i);
            if (!first || first->kind != CpuInst::Kind::op || !stands_in(firsts, first->op) ||
                first->type != (first->op == Op::to_float_ ? Type::uint_ : step.type))
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
    std::vector<uint32_t> def_;  // by register, like the following one
    std::vector<uint32_t> uses_;
    uint32_t block_ = 0;  // steps before it are not fused
};

class HashFinder {
public:
    HashFinder(Program& program, size_t registers)
        : steps_(program.steps), def_(registers, no_step), constants_(registers) {
        for (const Program::Constant& constant : program.constants)
            constants_[constant.reg] = constant.value;
    }

    void run() {
        for (uint32_t s = 0; s < steps_.size(); ++s) {
            CpuInst& step = steps_[s];
            if (step.kind != CpuInst::Kind::op || step.type != Type::uint_) continue;
            def_[step.out[0]] = s;
            const CpuInst* input = input_of_hash(step);
            if (!input) continue;
            step.in = {input->in[0]};
            step.count = 1;
            step.kind = CpuInst::Kind::hash;
            step.op = {};
        }
    }

private:
    // Returns the step that defines the register if it is this op; otherwise null.
    const CpuInst* is(uint32_t reg, Op op) const {
        const bool found = def_[reg] != no_step && steps_[def_[reg]].op == op;
        return found ? &steps_[def_[reg]] : nullptr;
    }
    // The same, if its second operand is this constant.
    const CpuInst* is(uint32_t reg, Op op, uint32_t constant) const {
        const CpuInst* step = is(reg, op);
        return step && constants_[step->in[1]] == constant ? step : nullptr;
    }

    // If the step computes a hash, returns the first step of it.
    const CpuInst* input_of_hash(const CpuInst& hash) const {
        constexpr PcgConstants pcg;
        if (hash.op != Op::bit_xor_) return nullptr;
        const CpuInst* last = is(hash.in[0], Op::shift_right_, pcg.last_shift);
        const CpuInst* product = is(hash.in[1], Op::mul_, pcg.factor);
        if (!last || !product || last->in[0] != hash.in[1]) return nullptr;
        const CpuInst* mixed = is(product->in[0], Op::bit_xor_);
        const CpuInst* shifted = mixed ? is(mixed->in[0], Op::shift_right_) : nullptr;
        const CpuInst* by = shifted ? is(shifted->in[1], Op::add_, pcg.least_shift) : nullptr;
        const CpuInst* top = by ? is(by->in[0], Op::shift_right_, pcg.shift) : nullptr;
        if (!top || top->in[0] != mixed->in[1] || shifted->in[0] != mixed->in[1]) return nullptr;
        const CpuInst* sum = is(mixed->in[1], Op::add_, pcg.increment);
        return sum ? is(sum->in[0], Op::mul_, pcg.multiplier) : nullptr;
    }

    std::vector<CpuInst>& steps_;
    std::vector<uint32_t> def_;      // by register, like the following one
    std::vector<double> constants_;  // 0: also none
};

}  // namespace

void recognise_hashes(Program& program, size_t registers) {
    HashFinder(program, registers).run();
}

void fuse_steps(Program& program, size_t registers) {
    Fuser(program, registers).run();
}

}  // namespace wrinkle

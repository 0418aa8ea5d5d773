// Steps that share a pass over memory: a part of compile_program(). Sums of products become dots,
// and an op whose value one other op reads becomes a pair with it. Nothing is rounded otherwise.
#include <algorithm>

#include "cpu/flatten.h"
#include "cpu/pairs.h"

namespace wrinkle {
namespace {

constexpr uint32_t no_step = ~0u;

class Fuser {
public:
    Fuser(Program& program, size_t registers)
        : steps_(program.steps), maker_(registers, no_step), reads_(registers, 0) {
        for (const Step& step : steps_)
            for (uint32_t i = 0; i < step.count; ++i)
                ++reads_[step.in[i]];
        for (const Program::Output& output : program.outputs)
            for (const uint32_t reg : output.regs)
                ++reads_[reg];
    }

    void run() {
        for (uint32_t s = 0; s < steps_.size(); ++s) {
            Step& step = steps_[s];
            // Where a loop begins, turns or ends, what was made before may be read again.
            if (step.kind >= Step::Kind::move) block_ = s;
            if (step.kind != Step::Kind::op || step.type != Type::float_) continue;
            if (!sum_of_products(step)) pair(step);
            if (step.outputs == 1) maker_[step.out[0]] = s;
        }
        drop_what_was_taken();
    }

private:
    // The step that makes an operand, when nobody else reads it and it may move down to `reader`.
    Step* sole_maker(const Step& reader, uint32_t i) {
        const uint32_t maker = maker_[reader.in[i]];
        if (maker == no_step || maker < block_ || reads_[reader.in[i]] != 1) return nullptr;
        Step& step = steps_[maker];
        return step.lod_of == reader.lod_of ? &step : nullptr;
    }

    static bool is(const Step* step, Op op, uint8_t count) {
        return step && step->kind == Step::Kind::op && step->op == op && step->count == count;
    }

    // a * b + c * d, or a dot of two lanes and a * b: a dot, whose sum goes the same way.
    bool sum_of_products(Step& step) {
        if (step.op != Op::add_ || step.in[0] == step.in[1]) return false;
        Step *a = sole_maker(step, 0), *b = sole_maker(step, 1);
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

    void pair(Step& step) {
        if (step.count != 2 || !stands_in(second_ops, step.op) || step.in[0] == step.in[1]) return;
        for (const uint32_t i : {0u, 1u}) {
            Step* first = sole_maker(step, i);
            if (!first || first->kind != Step::Kind::op || !stands_in(first_ops, first->op))
                continue;
            const uint32_t other = step.in[1 - i];
            step.second = step.op;
            step.swapped = i == 1;
            step.op = first->op;
            step.kind = Step::Kind::pair;
            step.in = {first->in[0], first->count == 2 ? first->in[1] : first->in[0], other};
            step.count = 3;
            return take(*first);
        }
    }

    // The step's work is done elsewhere.
    static void take(Step& step) {
        step.outputs = 0;
        step.count = 0;
    }

    void drop_what_was_taken() {
        std::vector<uint32_t> place;
        std::vector<Step> kept;
        for (const Step& step : steps_) {
            place.push_back(static_cast<uint32_t>(kept.size()));
            if (step.kind == Step::Kind::op && step.outputs == 0) continue;
            kept.push_back(step);
            if (step.kind == Step::Kind::loop_end) kept.back().extra = place[step.extra];
        }
        steps_ = std::move(kept);
    }

    std::vector<Step>& steps_;
    std::vector<uint32_t> maker_;  // by register
    std::vector<uint32_t> reads_;
    uint32_t block_ = 0;  // steps before it are not touched
};

}  // namespace

void fuse_steps(Program& program, size_t registers) {
    Fuser(program, registers).run();
}

}  // namespace wrinkle

#include "ir/value_facts.h"

#include "ir/derive.h"

namespace wrinkle {
namespace {

bool is_sample(Op op) {
    return op == Op::sample_ || op == Op::sample_lod_ || op == Op::sample_grad_;
}

bool makes_jumps(Op op) {
    return op == Op::floor_ || op == Op::ceil_ || op == Op::fract_ || op == Op::mod_ ||
           op == Op::select_ || op == Op::atan2_ || op == Op::loop_;
}

}  // namespace

ValueFacts::Facts ValueFacts::of(Id id) const {
    const Module& m = *module_;
    const Inst& inst = m[id];
    if (inst.op == Op::literal_ || inst.op == Op::resolve_) return 0;
    if (inst.op == Op::input_) return 1U << static_cast<uint32_t>(input_of(inst.extra));
    if (inst.op == Op::region_param_ && m.is_open_input(id)) {
        const OpenInput& input = m.open_inputs[inst.extra];
        return input.dependencies | (input.jumps ? jumping : 0) | (input.reads ? reading : 0);
    }
    if (inst.op == Op::result_)
        if (const Id result = m.open_result(id)) return facts_[result];
    if (inst.op == Op::loop_ || inst.op == Op::call_) return of_region(id);
    return of_op(inst, facts_[inst.arg[0]] | facts_[inst.arg[1]] | facts_[inst.arg[2]] |
                           facts_[inst.arg[3]]);
}

// `facts`: of its operands.
ValueFacts::Facts ValueFacts::of_op(const Inst& inst, Facts facts) {
    const bool seen_as_steps = inst.op == Op::detach_ && facts & reading;
    if (is_sample(inst.op)) facts |= reading;
    if (makes_jumps(inst.op) || seen_as_steps) facts |= jumping;
    return never_changes(inst) ? facts & ~all_inputs : facts;
}

// With the inputs that the body of what is run changes with; an open one's are known by result.
ValueFacts::Facts ValueFacts::of_region(Id id) const {
    Facts facts = 0;
    for (const Id operand : module_->operands(id))
        facts |= facts_[operand];
    const Inst& inst = (*module_)[id];
    const Region& region = module_->region(inst.extra);
    Facts inside = 0;
    if (!region.is_open())
        for (const Id result : region.results)
            inside |= facts_[result];
    return of_op(inst, facts) | (inside & all_inputs);
}

bool is_position_alone(uint32_t dependencies) {
    return dependencies == 1U << static_cast<uint32_t>(SurfaceInput::position_);
}

}  // namespace wrinkle

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
    if (m.is_open_input(id)) {
        const OpenInput& input = m.open_inputs[inst.extra];
        return input.dependencies | (input.jumps ? jumping : 0) | (input.reads ? reading : 0);
    }
    if (inst.op == Op::result_)
        if (const Id result = m.open_result(id)) return facts_[result];
    const bool listed = inst.op == Op::loop_ || inst.op == Op::call_;
    Facts facts = 0;
    for (const Id operand : listed ? m.operands(id) : std::span<const Id>(inst.arg))
        facts |= facts_[operand];
    if (inst.op == Op::detach_ && facts & reading) facts |= jumping;
    if (is_sample(inst.op)) facts |= reading;
    if (makes_jumps(inst.op)) facts |= jumping;
    if (never_changes(inst)) return facts & ~all_inputs;
    return facts | of_region(inst);
}

// The inputs that the body of what is run changes with; an open one's are known by result.
ValueFacts::Facts ValueFacts::of_region(const Inst& inst) const {
    if (inst.op != Op::loop_ && inst.op != Op::call_) return 0;
    const Region& region = module_->region(inst.extra);
    if (region.is_open()) return 0;
    Facts facts = 0;
    for (const Id result : region.results)
        facts |= facts_[result];
    return facts & all_inputs;
}

bool is_position_alone(uint32_t dependencies) {
    return dependencies == 1U << static_cast<uint32_t>(SurfaceInput::position_);
}

}  // namespace wrinkle

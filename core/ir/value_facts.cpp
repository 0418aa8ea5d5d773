#include "ir/value_facts.h"

#include "ir/derive.h"

namespace wrinkle {

void ValueFacts::update() {
    facts_.reserve(module_->size());
    while (facts_.size() < module_->size())
        facts_.push_back(of(static_cast<Id>(facts_.size())));
}

ValueFacts::Facts ValueFacts::of(Id id) const {
    const Module& m = *module_;
    const Inst& inst = m[id];
    Facts facts;
    if (m.is_open_input(id)) {
        const OpenInput& input = m.open_inputs[inst.extra];
        return {input.dependencies, input.jumps, input.reads};
    }
    if (const Id result = m.open_result(id)) return facts_[result];
    add_jumps(id, facts);
    add_dependencies(id, facts);
    return facts;
}

void ValueFacts::add_jumps(Id id, Facts& facts) const {
    const Op op = (*module_)[id].op;
    if (op == Op::resolve_) return;
    facts.reads = op == Op::sample_ || op == Op::sample_lod_ || op == Op::sample_grad_;
    facts.jumps = op == Op::floor_ || op == Op::ceil_ || op == Op::fract_ || op == Op::mod_ ||
                  op == Op::select_ || op == Op::atan2_ || op == Op::loop_;
    for (const Id operand : module_->operands(id)) {
        facts.reads = facts.reads || facts_[operand].reads;
        facts.jumps =
            facts.jumps || facts_[operand].jumps || (op == Op::detach_ && facts_[operand].reads);
    }
}

void ValueFacts::add_dependencies(Id id, Facts& facts) const {
    const Module& m = *module_;
    const Inst& inst = m[id];
    if (inst.op == Op::input_)
        facts.dependencies = 1U << static_cast<uint32_t>(input_of(inst.extra));
    if (inst.op == Op::resolve_ || never_changes(inst)) return;
    for (const Id operand : m.operands(id))
        facts.dependencies |= facts_[operand].dependencies;
    if (inst.op != Op::loop_ && inst.op != Op::call_) return;
    const Region& region = m.region(inst.extra);
    if (!region.is_open())
        for (const Id result : region.results)
            facts.dependencies |= facts_[result].dependencies;
}

bool is_position_alone(uint32_t dependencies) {
    return dependencies == 1U << static_cast<uint32_t>(SurfaceInput::position_);
}

}  // namespace wrinkle

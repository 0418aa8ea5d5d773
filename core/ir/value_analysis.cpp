#include "ir/value_analysis.h"

namespace wrinkle {
constinit const std::array<ValueAnalysis::Effect, tables::op_count> ValueAnalysis::effects = [] {
    std::array<Effect, tables::op_count> effects{};
    for (size_t op = 0; op < effects.size(); ++op) {
        const OpInfo& row = tables::ops[op];
        if (row.flags & WR_FLAG_ZERO_DERIVATIVE || row.rule == Rule::leaf)
            effects[op].keeps = ~all_inputs;
    }
    effects[static_cast<size_t>(Op::resolve_)].keeps = varying;
    for (const Op op : {Op::sample_, Op::sample_lod_, Op::sample_grad_})
        effects[static_cast<size_t>(op)].adds = reading;
    for (const Op op :
         {Op::floor_, Op::ceil_, Op::fract_, Op::mod_, Op::select_, Op::atan2_, Op::loop_})
        effects[static_cast<size_t>(op)].adds = jumping;
    return effects;
}();

ValueAnalysis::ValueAnalysis(const Module& module) : module_(&module) {
    facts_.reserve(module.size());
    update();
}

void ValueAnalysis::update() {
    auto id = static_cast<Id>(facts_.size());
    facts_.resize(module_->size());
    for (; id < facts_.size(); ++id)
        facts_[id] = of(id);
}

ValueAnalysis::Facts ValueAnalysis::of(Id id) const {
    const Module& m = *module_;
    const Inst& inst = m[id];
    switch (inst.op) {
        case Op::input_:
            return varying | 1U << static_cast<uint32_t>(input_of(inst.extra));
        case Op::region_param_: {
            if (!m.is_open_input(id)) return varying;
            const OpenInput& input = m.open_inputs[inst.extra];
            return varying | input.dependencies | (input.discontinuous ? jumping : 0) |
                   (input.samples_texture ? reading : 0);
        }
        case Op::result_:
            if (const Id result = m.open_result(id)) return facts_[result];
            break;
        case Op::loop_:
        case Op::call_:
            return of_region(id);
        default:
            break;
    }
    return of_op(inst, facts_[inst.arg[0]] | facts_[inst.arg[1]] | facts_[inst.arg[2]] |
                           facts_[inst.arg[3]]);
}

// `facts` are those of the operands.
ValueAnalysis::Facts ValueAnalysis::of_op(const Inst& inst, Facts facts) const {
    const Effect& effect = effects[static_cast<size_t>(inst.op)];
    const bool seen_as_steps = inst.op == Op::detach_ && facts & reading;
    const Facts choosing = inst.op == Op::select_ ? facts_[inst.arg[0]] : facts;
    const Facts adds = choosing & varying ? effect.adds : effect.adds & ~jumping;
    facts = (facts & effect.keeps) | adds | (seen_as_steps ? jumping : 0);
    return is_whole_type(inst.type) ? facts & ~all_inputs : facts;
}

// Includes the inputs that the region's body depends on; for an open function they are known per
// result.
ValueAnalysis::Facts ValueAnalysis::of_region(Id id) const {
    Facts facts = 0;
    for (const Id operand : module_->operands(id))
        facts |= facts_[operand];
    const Inst& inst = (*module_)[id];
    const Region& region = module_->region(inst.extra);
    Facts inside = 0;
    if (!region.is_open())
        for (const Id result : region.results)
            inside |= facts_[result];
    return of_op(inst, facts | (inside & varying)) | (inside & all_inputs);
}

bool is_position_alone(uint32_t dependencies) {
    return dependencies == 1U << static_cast<uint32_t>(SurfaceInput::position_);
}

}  // namespace wrinkle

// Derivatives of calls: derived functions.
#include "ir/derive.h"
#include "ir/module_cloner.h"
#include "ir/value.h"

namespace wrinkle {

// A slope is one vector.
constexpr uint32_t most_slope_lanes = 4;

Id ForwardDiff::call_member(const Inst& result) {
    const Inst call = (*module_)[result.arg[0]];
    const auto operands = module_->operands(result.arg[0]);
    std::vector<Id> args(operands.begin(), operands.end());
    std::vector<bool> active;
    std::vector<Id> derivatives;
    uint32_t lanes = 0;
    const Activity& matters = influences(call.extra, result.extra);
    for (size_t k = 0; k < args.size(); ++k) {
        const Id arg = args[k], derivative = matters[k] ? memo_.at(arg) : no_id;
        active.push_back(derivative != no_id);
        if (!derivative) continue;
        derivatives.push_back(derivative);
        lanes += info(module_->type(arg)).lanes;
    }
    if (derivatives.empty()) return no_id;
    if (result.type == Type::float_ && lanes <= most_slope_lanes)
        return call_along(result, active, args);
    const DerivedFunction& function = derived(call.extra, active);
    const int member = function.member[result.extra];
    if (member < 0) return no_id;
    args.insert(args.end(), derivatives.begin(), derivatives.end());
    return module_->result(module_->apply_region(function.region, args),
                           static_cast<uint32_t>(member));
}

// Returns the parameters of a function that the derivative of one of its results depends on, so not
// those that are only detached or the footprint of a sample.
const ForwardDiff::Activity& ForwardDiff::influences(uint32_t index, uint32_t member) {
    const auto [entry, added] = functions_.influences.try_emplace({index, member});
    Activity& active = entry->second;
    if (!added) return active;
    const Module& m = *module_;
    active.resize(m.region(index).params.size());
    const Id root = m.region(index).results[member];
    walk({&root, 1}, [&](Id id, std::vector<Id>& open) {
        const Inst& inst = m[id];
        if (inst.op == Op::region_param_ && inst.level == 1) active[inst.extra] = true;
        if (has_zero_derivative(inst)) return;
        const Id applied = inst.op == Op::result_ ? inst.arg[0] : no_id;
        if (applied == no_id || m[applied].op != Op::call_) {
            const std::vector<Id> reads = reads_of(m, id);
            open.insert(open.end(), reads.begin(), reads.end());
            return;
        }
        const Activity& matters = influences(m[applied].extra, inst.extra);
        for (size_t k = 0; k < matters.size(); ++k)
            if (matters[k]) open.push_back(m.operands(applied)[k]);
    });
    return active;
}

// The slope times the derivatives of the arguments. Factors of a vector scale the dot product.
Id ForwardDiff::call_along(const Inst& result, const Activity& active, std::span<const Id> args) {
    const uint32_t function = slope_function((*module_)[result.arg[0]].extra, result.extra, active);
    if (function == 0) return no_id;
    const Id slope = module_->result(module_->apply_region(function, args), 0);
    Value sum{module_, no_id};
    uint32_t lane = 0;
    for (size_t k = 0; k < args.size(); ++k) {
        if (!active[k]) continue;
        const int count = info(module_->type(args[k])).lanes;
        auto part = static_cast<uint32_t>(count);
        for (int i = 0; i < count; ++i)
            part |= swizzle_lane(static_cast<int>(lane++), i);
        const Value derivative{module_, memo_.at(args[k])};
        const auto [along, factor] =
            count == 1 ? Scaled{derivative, {}} : without_factors(derivative, {});
        const Value partial{module_, module_->type(slope) == Type::float_
                                         ? slope
                                         : module_->add(Op::swizzle_, {slope}, part)};
        const Value change = count == 1 ? partial * along : dot(partial, along);
        sum = sum_of(sum, product_of(change, factor));
    }
    return sum.id;
}

// Returns the function of the same parameters that returns the derivative of result `member` with
// respect to each component of the active parameters; 0 if it is zero.
uint32_t ForwardDiff::slope_function(uint32_t index, uint32_t member, const Activity& active) {
    const auto [entry, added] = functions_.slopes.try_emplace({index, member, active});
    if (!added) return entry->second;
    Region region = module_->region(index);
    std::vector<Id> partials;
    for (uint32_t k = 0; k < region.params.size(); ++k) {
        const Type type = region.params[k];
        for (uint32_t lane = 0; active[k] && lane < info(type).lanes; ++lane) {
            ForwardDiff inside(*module_);
            inside.functions_ = std::move(functions_);
            inside.seed(module_->region_parameter(1, k, type), module_->unit(type, lane));
            partials.push_back(inside.jvp_or_zero(region.results[member]));
            functions_ = std::move(inside.functions_);
        }
    }
    const Id slope = partials.size() == 1
                         ? partials[0]
                         : module_->add(Op::construct_, partials, 0,
                                        vector_of(static_cast<int>(partials.size())));
    if (module_->is_literal(slope, 0)) return 0;
    region.results = {slope};
    region.name += "_slope";
    if (!region.result_names.empty())
        region.result_names = {region.result_names[member] + "_slope"};
    return functions_.slopes[{index, member, active}] = module_->intern_region(std::move(region));
}

const ForwardDiff::DerivedFunction& ForwardDiff::derived(uint32_t index, const Activity& active) {
    const auto [entry, added] = functions_.derived.try_emplace({index, active});
    if (!added) return entry->second;
    Region region = module_->region(index);
    ForwardDiff inside(*module_);
    inside.functions_ = std::move(functions_);
    const auto own = static_cast<uint32_t>(region.params.size());
    for (uint32_t k = 0; k < own; ++k) {
        if (!active[k]) continue;
        const Type type = region.params[k];
        inside.seed(
            module_->region_parameter(1, k, type),
            module_->region_parameter(1, static_cast<uint32_t>(region.params.size()), type));
        region.params.push_back(type);
        if (k < region.param_names.size())
            region.param_names.push_back(region.param_names[k] + "_change");
    }
    DerivedFunction function;
    std::vector<Id> results;
    std::vector<std::string> names;
    for (size_t k = 0; k < region.results.size(); ++k) {
        const Id derivative = inside.jvp(region.results[k]);
        function.member.push_back(derivative ? static_cast<int>(results.size()) : -1);
        if (derivative) results.push_back(derivative);
        if (derivative && k < region.result_names.size())
            names.push_back(region.result_names[k] + "_change");
    }
    functions_ = std::move(inside.functions_);
    region.results = std::move(results);
    region.name += "_change";
    region.result_names = std::move(names);
    if (!region.results.empty()) function.region = module_->intern_region(std::move(region));
    return functions_.derived[{index, active}] = std::move(function);
}

}  // namespace wrinkle

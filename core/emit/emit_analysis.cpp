#include "emit/emit_analysis.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "emit/literal.h"

namespace wrinkle {

EmitAnalysis::EmitAnalysis(const Module& module, const Language& language, bool given)
    : parameters_used(module.parameters.size()),
      module_(&module),
      language_(&language),
      given_(given),
      values_(module.size()),
      seen_function_(module.region_count()),
      seen_resource_(module.resources.size()) {
    operands_.reserve(module.size() * size_t{2});
    literals_.reserve(module.size());
    if (module.region_count() > 1) find_members();
    find_names();
    walk();
    find_gradients();
}

// Selects one name per value: the first of a constant, else of a node's output, else the first.
void EmitAnalysis::find_names() {
    const std::vector<Named>& named = module_->named;
    for (uint32_t i = 0; i < named.size(); ++i) {
        Id value = strip_detach(named[i].value);
        // The name of a component is that of the texel or, in a function, of the called function's
        // result.
        const Inst& inst = (*module_)[value];
        const bool part = inst.op == Op::swizzle_ && !named[i].output;
        if (part &&
            (is_sample((*module_)[inst.arg[0]].op) || (inst.level > 0 && single_call(inst.arg[0]))))
            value = inst.arg[0];
        uint32_t& name = values_[value].name;
        const bool constant = module_->is_constant(value);
        const auto rank = [&](const Named& one) {
            return constant && !one.comment.empty() ? 2 : int(one.output);
        };
        if (name == 0 || rank(named[i]) > rank(named[name - 1])) name = i + 1;
    }
}

void EmitAnalysis::find_members() {
    const Module& m = *module_;
    for (Id id = 1; id < m.size(); ++id) {
        const Inst& inst = m[id];
        if (inst.op == Op::loop_)
            members_[id].resize(m.region(inst.extra).params.size(), no_id);
        else if (inst.op == Op::call_)
            members_[id].resize(m.region(inst.extra).results.size(), no_id);
        else if (inst.op == Op::result_)
            members_[inst.arg[0]][inst.extra] = id;
    }
}

Role EmitAnalysis::role_of(Id id) const {
    const Module& m = *module_;
    const Inst& inst = m[id];
    switch (inst.op) {
        case Op::poison_:
        case Op::literal_:
        case Op::parameter_:
        case Op::region_param_:
            return Role::leaf;
        case Op::input_:
            return given_ || variant_of(inst.extra) == Variant::value ? Role::leaf : Role::value;
        case Op::construct_:
            return inst.type != Type::mat3_ && m.is_constant(id) ? Role::leaf : Role::value;
        case Op::swizzle_:
            return role(strip_detach(inst.arg[0])) == Role::leaf &&
                           m[strip_detach(inst.arg[0])].op != Op::construct_
                       ? Role::leaf
                       : Role::view;
        case Op::column_:
            return Role::view;
        case Op::result_:
            return single_call(id) ? Role::value : Role::view;
        default:
            return Role::value;
    }
}

bool EmitAnalysis::single_call(Id id) const {
    const Module& m = *module_;
    if (m[id].op != Op::result_ || m[m[id].arg[0]].op != Op::call_) return false;
    return m.region(m[m[id].arg[0]].extra).results.size() == 1;
}

bool EmitAnalysis::is_splat(Id construct) const {
    const auto parts = module_->operands(construct);
    return module_->type(construct) != Type::mat3_ && info(module_->type(parts[0])).lanes == 1 &&
           std::all_of(parts.begin(), parts.end(), [&](Id part) { return part == parts[0]; });
}

void EmitAnalysis::list_operands(Id id) {
    const Module& m = *module_;
    const Op op = m[id].op;
    std::span<const Id> operands = m.operands(id);
    if (op == Op::construct_ && is_splat(id)) operands = operands.first(1);
    if (single_call(id)) operands = m.operands(m[id].arg[0]);
    for (const Id operand : operands)
        operands_.push_back(strip_detach(operand));
    if (op == Op::loop_) list_captures(m.region(m[id].extra));
}

// Appends the captures of a loop: outer values that its body reads and that must be temporaries, in
// the order of a walk through the body.
void EmitAnalysis::list_captures(const Region& loop) {
    const Module& m = *module_;
    std::unordered_set<Id> seen;
    std::vector<Id> open(loop.results.rbegin(), loop.results.rend());
    while (!open.empty()) {
        const Id id = strip_detach(open.back());
        open.pop_back();
        if (role(id) == Role::leaf || !seen.insert(id).second) continue;
        if (m[id].level < loop.level && (role(id) == Role::value || m[id].op == Op::result_)) {
            operands_.push_back(id);
            continue;
        }
        const auto parts = operands(id);
        open.insert(open.end(), parts.rbegin(), parts.rend());
    }
}

void EmitAnalysis::find_gradients() {
    while (!gradients_.empty()) {
        const Id id = gradients_.back();
        gradients_.pop_back();
        if (std::exchange(values_[id].gradient, true)) continue;
        if ((*module_)[id].op == Op::add_)
            gradients_.insert(gradients_.end(), operands(id).begin(), operands(id).end());
    }
}

void EmitAnalysis::walk() {
    const Module& m = *module_;
    std::vector<Id> stack;
    stack.reserve(64);
    const auto open = [&](std::span<const Id> ids) {
        for (size_t i = ids.size(); i-- > 0;)
            if (values_[ids[i]].met == VisitState::never) stack.push_back(ids[i]);
    };
    for (const ModuleOutput& output : m.outputs) {
        stack.push_back(output.value);
        while (!stack.empty()) {
            const Id id = stack.back();
            VisitState& met = values_[id].met;
            if (met == VisitState::never) {
                met = VisitState::open;
                const Op op = m[id].op;
                if (op == Op::loop_ || op == Op::call_) open(m.region(m[id].extra).results);
                open(m.operands(id));
                if (stack.back() != id) continue;
            }
            stack.pop_back();
            if (met == VisitState::open) use(id);
            met = VisitState::used;
        }
    }
}

void EmitAnalysis::use(Id id) {
    ++used_;
    Value& value = values_[id];
    const Inst& inst = (*module_)[id];
    value.role = role_of(id);
    value.reads = finds_reads(inst, module_->operands(id));
    if (inst.op == Op::literal_) {
        value.literal = true;
        value.begin = static_cast<uint32_t>(literals_.size());
        append_literal(*language_, literals_, inst.type, inst.value);
        value.count = static_cast<uint32_t>(literals_.size()) - value.begin;
        return use_constant(id);
    }
    value.begin = static_cast<uint32_t>(operands_.size());
    list_operands(id);
    value.count = static_cast<uint32_t>(operands_.size()) - value.begin;
    if (inst.op == Op::construct_) return use_constant(id);
    switch (inst.op) {
        case Op::input_:
            return use_input(inst.extra);
        case Op::parameter_:
            parameters_used[inst.extra] = true;
            return;
        case Op::sample_:
            implicit = true;
            [[fallthrough]];
        case Op::sample_lod_:
        case Op::sample_grad_:
        case Op::image_size_:
            return use_resource(id);
        case Op::call_:
            return use_function(inst.extra);
        case Op::normalize_:
            return use_normalize(inst);
        default:
            return;
    }
}

// A short literal, as 0.5, needs no name.
void EmitAnalysis::use_constant(Id id) {
    constexpr size_t max_short = 4;
    Value& value = values_[id];
    value.constant = value.role == Role::leaf && value.name > 0 && !name(id)->comment.empty() &&
                     (!value.literal || value.count > max_short);
    if (value.constant) constants.push_back(id);
}

bool EmitAnalysis::finds_reads(const Inst& inst, std::span<const Id> operands) const {
    const auto reads = [&](Id id) { return values_[id].reads; };
    if (reads_image(inst.op) || std::any_of(operands.begin(), operands.end(), reads)) return true;
    if (inst.op != Op::loop_ && inst.op != Op::call_) return false;
    const auto& results = module_->region(inst.extra).results;
    return std::any_of(results.begin(), results.end(), reads);
}

void EmitAnalysis::use_input(uint32_t extra) {
    inputs_used[input_slot(input_of(extra), variant_of(extra))] = true;
    implicit = implicit || (!given_ && variant_of(extra) != Variant::value);
}

void EmitAnalysis::use_resource(Id sample) {
    const uint32_t resource = (*module_)[sample].extra;
    reads_sizes = reads_sizes || (*module_)[sample].op == Op::image_size_;
    if (!seen_resource_[resource]) resources.push_back({resource, module_->origin[sample]});
    seen_resource_[resource] = true;
}

void EmitAnalysis::use_function(uint32_t region) {
    if (!seen_function_[region]) functions.push_back(region);
    seen_function_[region] = true;
}

// Records the gradient of normalize(n - gradient).
void EmitAnalysis::use_normalize(const Inst& inst) {
    const Id sum = strip_detach(inst.arg[0]);
    if (inst.type == Type::vec3_ && (*module_)[sum].op == Op::sub_)
        gradients_.push_back(operands(sum)[1]);
}

}  // namespace wrinkle

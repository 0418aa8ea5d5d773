#include "glsl/plan.h"

#include <algorithm>
#include <unordered_set>

#include "glsl/literal.h"

namespace wrinkle {

Plan::Plan(const Module& module, bool given)
    : inputs_used(surface_input_count * 3),
      parameters_used(module.parameters.size()),
      first_name(module.size()),
      is_gradient(module.size()),
      module_(&module),
      given_(given),
      met_(module.size()),
      captures_(module.region_count()),
      seen_function_(module.region_count()),
      seen_resource_(module.resources.size()) {
    find_aliases();
    if (module.region_count() > 1) find_members();
    for (const bool output : {true, false})
        for (uint32_t i = 0; i < module.named.size(); ++i) {
            const Id id = alias_[module.named[i].value];
            if (module.named[i].output == output && !first_name[id]) first_name[id] = i + 1;
        }
    for (uint32_t region = 1; region < module.region_count(); ++region)
        if (module.region(region).kind == RegionKind::loop) find_captures(region);
    walk();
    list_operands_and_literals();
    find_gradients();
}

void Plan::list_operands_and_literals() {
    const Module& m = *module_;
    first_operand_.resize(m.size() + size_t{1});
    literal_end_.resize(m.size());
    operands_.reserve(m.size() * size_t{2});
    for (Id id = 1; id < m.size(); ++id) {
        first_operand_[id] = static_cast<uint32_t>(operands_.size());
        literal_end_[id] = static_cast<uint32_t>(literals_.size());
        if (!is_used(id)) continue;
        const Inst& inst = m[id];
        if (inst.op != Op::literal_) {
            gather_operands(id, operands_);
        } else {
            append_literal(literals_, inst.type, inst.value);
            literal_end_[id] = static_cast<uint32_t>(literals_.size());
        }
    }
    first_operand_.back() = static_cast<uint32_t>(operands_.size());
}

std::string_view Plan::literal(Id id) const {
    const uint32_t begin = literal_end_[id - 1];
    return std::string_view(literals_).substr(begin, literal_end_[id] - begin);
}

void Plan::find_aliases() {
    const Module& m = *module_;
    alias_.resize(m.size());
    role_.resize(m.size(), Role::leaf);
    for (Id id = 1; id < m.size(); ++id) {
        alias_[id] = m[id].op == Op::detach_ ? alias_[m[id].arg[0]] : id;
        role_[id] = role_of(id);
    }
}

void Plan::find_members() {
    const Module& m = *module_;
    for (Id id = 1; id < m.size(); ++id) {
        const Inst& inst = m[id];
        if (inst.op == Op::loop_)
            members_[id].resize(m.region(inst.extra).params.size(), poison);
        else if (inst.op == Op::call_)
            members_[id].resize(m.region(inst.extra).results.size(), poison);
        else if (inst.op == Op::result_)
            members_[inst.arg[0]][inst.extra] = id;
    }
}

Role Plan::role_of(Id id) const {
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
            return role_[alias_[inst.arg[0]]] == Role::leaf &&
                           m[alias_[inst.arg[0]]].op != Op::construct_
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

bool Plan::single_call(Id id) const {
    const Module& m = *module_;
    if (m[id].op != Op::result_ || m[m[id].arg[0]].op != Op::call_) return false;
    return m.region(m[m[id].arg[0]].extra).results.size() == 1;
}

bool Plan::is_splat(Id construct) const {
    const auto parts = module_->operands(construct);
    return module_->type(construct) != Type::mat3_ && info(module_->type(parts[0])).lanes == 1 &&
           std::all_of(parts.begin(), parts.end(), [&](Id part) { return part == parts[0]; });
}

// Appends them.
void Plan::gather_operands(Id id, std::vector<Id>& result) const {
    const Module& m = *module_;
    const Op op = m[id].op;
    std::span<const Id> operands = m.operands(id);
    if (op == Op::construct_ && is_splat(id)) operands = operands.first(1);
    if (op == Op::result_ && single_call(id)) operands = m.operands(m[id].arg[0]);
    for (const Id operand : operands)
        result.push_back(alias_[operand]);
    if (op != Op::loop_) return;
    const auto& captured = captures_[m[id].extra];
    result.insert(result.end(), captured.begin(), captured.end());
}

// What the body reads from outside that must be a temporary there, in the order it is met.
void Plan::find_captures(uint32_t region) {
    const Module& m = *module_;
    const uint8_t level = m.region(region).level;
    std::unordered_set<Id> seen;
    std::vector<Id> open(m.region(region).results.rbegin(), m.region(region).results.rend());
    std::vector<Id> parts;
    while (!open.empty()) {
        const Id id = alias_[open.back()];
        open.pop_back();
        if (role_[id] == Role::leaf || !seen.insert(id).second) continue;
        if (m[id].level < level && (role_[id] == Role::value || m[id].op == Op::result_)) {
            captures_[region].push_back(id);
            continue;
        }
        parts.clear();
        gather_operands(id, parts);
        open.insert(open.end(), parts.rbegin(), parts.rend());
    }
}

// normalize(n - gradient): readers comes before what they read in this walk.
void Plan::find_gradients() {
    const Module& m = *module_;
    for (Id id = m.size(); id-- > 1;) {
        if (!is_used(id)) continue;
        const Inst& inst = m[id];
        if (inst.op == Op::normalize_ && inst.type == Type::vec3_ &&
            m[alias_[inst.arg[0]]].op == Op::sub_)
            is_gradient[alias_[m[alias_[inst.arg[0]]].arg[1]]] = true;
        if (!is_gradient[id] || inst.op != Op::add_) continue;
        is_gradient[alias_[inst.arg[0]]] = true;
        is_gradient[alias_[inst.arg[1]]] = true;
    }
}

void Plan::walk() {
    const Module& m = *module_;
    std::vector<Id> stack;
    stack.reserve(64);
    const auto open = [&](std::span<const Id> ids) {
        for (size_t i = ids.size(); i-- > 0;)
            if (met_[ids[i]] == Met::never) stack.push_back(ids[i]);
    };
    for (const ModuleOutput& output : m.outputs) {
        stack.push_back(output.value);
        while (!stack.empty()) {
            const Id id = stack.back();
            if (met_[id] == Met::never) {
                met_[id] = Met::open;
                const Op op = m[id].op;
                if (op == Op::loop_ || op == Op::call_) open(m.region(m[id].extra).results);
                open(m.operands(id));
                if (stack.back() != id) continue;
            }
            stack.pop_back();
            if (met_[id] == Met::open) use(id);
            met_[id] = Met::used;
        }
    }
}

void Plan::use(Id id) {
    ++used_;
    const Inst& inst = (*module_)[id];
    switch (inst.op) {
        case Op::input_:
            inputs_used[input_slot(input_of(inst.extra), variant_of(inst.extra))] = true;
            implicit = implicit || (!given_ && variant_of(inst.extra) != Variant::value);
            break;
        case Op::parameter_:
            parameters_used[inst.extra] = true;
            break;
        case Op::sample_:
            implicit = true;
            [[fallthrough]];
        case Op::sample_lod_:
        case Op::sample_grad_:
        case Op::image_size_:
            if (!seen_resource_[inst.extra]) resources.push_back({inst.extra, module_->origin[id]});
            seen_resource_[inst.extra] = true;
            break;
        case Op::call_:
            if (!seen_function_[inst.extra]) functions.push_back(inst.extra);
            seen_function_[inst.extra] = true;
            break;
        default:
            break;
    }
}

}  // namespace wrinkle

#include "ir/module_cloner.h"

#include "base/limits.h"

namespace wrinkle {
namespace {

bool has_base(const Inst& inst) {
    return inst.type == Type::gradient_ && inst.extra != no_id;
}

}  // namespace

bool is_global(const Module& module, Id id) {
    return module.is_constant(id) || module[id].op == Op::parameter_ ||
           module[id].op == Op::image_size_;
}

bool is_of_globals(const Module& module, Id value) {
    bool all = true;
    walk({&value, 1}, [&](Id id, std::vector<Id>& open) {
        if (is_global(module, id)) return;
        const Op op = module[id].op;
        all = all && info(op).rule != Rule::leaf && !is_sample(op) && !is_opaque(op);
        if (all) append_dependencies(module, id, false, open);
    });
    return all;
}

void append_dependencies(const Module& module, Id id, bool into_functions, std::vector<Id>& out) {
    const Inst& inst = module[id];
    const auto operands = module.operands(id);
    out.insert(out.end(), operands.begin(), operands.end());
    if (has_base(inst)) out.push_back(inst.extra);
    if (inst.op != Op::loop_ && !(inst.op == Op::call_ && into_functions)) return;
    const std::vector<Id>& results = module.region(inst.extra).results;
    out.insert(out.end(), results.begin(), results.end());
}

std::vector<Id> ModuleCloner::reachable_ids(std::span<const Id> roots) const {
    std::vector<Id> list;
    walk(roots, [&](Id id, std::vector<Id>& open) {
        if (ids_.has(id)) return;
        list.push_back(id);
        append_dependencies(*source_, id, false, open);
    });
    std::sort(list.begin(), list.end());
    return list;
}

// If the module becomes too large, OverLimit names the node of the source instruction, not that of
// its operands.
void ModuleCloner::run(std::span<const Id> roots) {
    ids_.set(no_id, no_id);
    const uint32_t node = target_->current_node;
    const auto rewrite = [&](Id id) {
        const uint32_t origin = target_->current_node = source_->origin[id];
        try {
            ids_.set(id, write(id));
            give_names(id);
        } catch (OverLimit& over) {
            if (origin != 0) over.node = origin;
            over.path = (into_functions_ ? target_ : source_)->nodes[over.node].path;
            throw;
        }
    };
    if (into_functions_) {
        const std::vector<bool> reached = reachable(*source_, roots);
        for (Id id = 0; id < reached.size(); ++id)
            if (reached[id] && !ids_.has(id)) rewrite(id);
    } else {
        for (const Id id : reachable_ids(roots))
            rewrite(id);
    }
    target_->current_node = node;
}

// Precondition: ids ascend from call to call.
void ModuleCloner::give_names(Id id) {
    for (; next_name_ < names_.size() && names_[next_name_].value <= id; ++next_name_) {
        Named& named = names_[next_name_];
        if (named.value != id || info(source_->type(id)).lanes == 0) continue;
        named.value = ids_.at(id);
        target_->named.push_back(std::move(named));
    }
}

Id ModuleCloner::write_leaf(Inst inst) {
    if (inst.op == Op::parameter_) return target_->parameter(inst.extra);
    const int level = shifted(inst.level);
    if (inst.op == Op::poison_ || level > Module::max_region) return poison;
    inst.level = static_cast<uint8_t>(level);
    return target_->leaf(inst);
}

Id ModuleCloner::write_apply(const Inst& inst, std::span<const Id> args) {
    Region region = source_->region(inst.extra);
    if (inst.op == Op::loop_) {
        const int level = shifted(region.level);
        if (level > Module::max_region) {
            target_->problem("loops are nested more than " + std::to_string(Module::max_region) +
                             " deep");
            return poison;
        }
        region.level = static_cast<uint8_t>(level);
    }
    if (inst.op == Op::loop_ || into_functions_)
        for (Id& result : region.results)
            if ((result = ids_.at(result)) == poison) return poison;
    return target_->apply_region(target_->intern_region(std::move(region)), args);
}

// Returns the replacement from the Replace callback, or no_id.
Id ModuleCloner::replaced(Id id, std::span<const Id> args) {
    if (!replace_) return no_id;
    const Inst& inst = (*source_)[id];
    if (!into_functions_ || inst.op != Op::call_ || !source_->region(inst.extra).is_open())
        return replace_(context_, *target_, *source_, id, args);
    std::vector<Id> with_results(args.begin(), args.end());
    for (const Id result : source_->region(inst.extra).results)
        with_results.push_back(ids_.at(result));
    return replace_(context_, *target_, *source_, id, with_results);
}

Id ModuleCloner::write(Id id) {
    const Inst inst = (*source_)[id];
    const auto operands = source_->operands(id);
    if (args_.size() < operands.size()) args_.resize(operands.size());
    const std::span args(args_.data(), operands.size());
    const bool based = has_base(inst);
    // Within one module, an instruction with unchanged operands stays one value.
    bool kept = !into_functions_ && shift_ == 0 && (!based || is_kept(inst.extra));
    for (size_t i = 0; i < args.size(); ++i) {
        kept = kept && is_kept(operands[i]);
        args[i] = ids_.at(operands[i]);
    }
    if (const Id other = replaced(id, args)) return other;
    if (inst.op == Op::loop_ || inst.op == Op::call_) return write_apply(inst, args);
    if (info(inst.op).rule == Rule::leaf) return write_leaf(inst);
    if (kept) return id;
    if (inst.op == Op::result_) return target_->result(args[0], inst.extra);
    const uint32_t extra = based ? ids_.at(inst.extra) : inst.extra;
    return target_->add(inst.op, args, extra, inst.type);
}

}  // namespace wrinkle

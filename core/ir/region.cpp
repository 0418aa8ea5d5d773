// Regions of a Module: closing functions over captured values, interning, applying.
#include <algorithm>
#include <cassert>
#include <utility>

#include "ir/module.h"
#include "ir/module_cloner.h"

namespace wrinkle {

RegionBody region_body(const Module& m, const Region& region) {
    RegionBody body;
    walk(region.results, [&](Id id, std::vector<Id>& open) {
        if (is_global(m, id)) return;
        const Inst& inst = m[id];
        if (inst.level < region.level) return body.captured.push_back(id);
        if (inst.op == Op::region_param_ && inst.level == region.level)
            body.parameters_fit = body.parameters_fit && inst.extra < region.params.size() &&
                                  region.params[inst.extra] == inst.type;
        if (inst.op == Op::call_) body.called.push_back(inst.extra);
        append_dependencies(m, id, false, open);
    });
    return body;
}

bool Module::fits(const OpenRegion& open, std::span<const Id> results) {
    for (const Id result : results) {
        if (result == poison) return false;
        if (info(type(result)).lanes > 0) continue;
        problem("a loop or a function gives numbers, not a " + std::string(info(type(result)).name),
                "make heights or slopes there, and the gradient outside");
        return false;
    }
    if (open.kind == RegionKind::function) return !results.empty();
    bool fit = results.size() == open.params.size() + 1 && type(results[0]) == Type::bool_;
    for (size_t k = 0; fit && k < open.params.size(); ++k)
        fit = type(results[k + 1]) == open.params[k];
    if (!fit) problem("a loop must give a bool \"continue\" and a next state of the same types");
    return fit;
}

bool Module::fits(const RegionBody& body) {
    if (!body.parameters_fit)
        problem("a loop or a function reads a parameter of another one");
    else if (calls_below(body) >= max_call)
        problem("functions call each other more than " + std::to_string(max_call) + " deep");
    else
        return true;
    return false;
}

// Splits "noise(point, width)" into the function's name and those of its parameters.
static void set_names(Region& region, std::string_view signature) {
    const size_t open = signature.find('(');
    region.name = signature.substr(0, open);
    if (open == std::string_view::npos) return;
    std::string_view rest = signature.substr(open + 1);
    region.param_names.resize(region.params.size());
    for (std::string& name : region.param_names) {
        const size_t end = rest.find_first_of(",)");
        name = rest.substr(0, end);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (rest.starts_with(' ')) rest.remove_prefix(1);
    }
}

std::vector<Id> Module::begin_region(RegionKind kind, std::string name,
                                     std::span<const Type> params) {
    open_.push_back({kind, std::move(name), {params.begin(), params.end()}, named.size()});
    if (depth() > max_region) return std::vector<Id>(params.size(), poison);
    std::vector<Id> ids;
    for (uint32_t k = 0; k < params.size(); ++k)
        ids.push_back(region_parameter(depth(), k, params[k]));
    return ids;
}

RegionUse Module::end_region(std::span<const Id> results, uint32_t max_iterations) {
    assert(!open_.empty());
    const int level = depth();
    const OpenRegion open = std::move(open_.back());
    open_.pop_back();
    if (level > max_region) {
        problem("loops and functions are nested more than " + std::to_string(max_region) + " deep");
        return {};
    }
    if (!fits(open, results)) return {};
    Region region;
    region.kind = open.kind;
    region.max_iterations = max_iterations;
    region.params = open.params;
    region.results.assign(results.begin(), results.end());
    set_names(region, open.name);
    region.level = static_cast<uint8_t>(level);
    RegionBody body = region_body(*this, region);
    if (!fits(body)) return {};
    if (open.kind == RegionKind::loop) return {intern_region(std::move(region), body), {}};
    RegionUse use;
    use.captured = std::exchange(body.captured, {});
    std::erase_if(use.captured, [&](Id id) { return is_of_globals(*this, id); });
    ModuleCloner copier(*this, *this, false);
    copier.set_shift(level, 1 - level);
    for (const Id id : use.captured) {
        const auto index = static_cast<uint32_t>(region.params.size());
        region.params.push_back(type(id));
        if (!region.param_names.empty()) region.param_names.emplace_back();
        copier.map(id, region_parameter(1, index, type(id)));
    }
    region.level = 1;
    copier.run(results);
    name_copies(open.first_name, copier);
    for (Id& result : region.results)
        result = copier[result];
    use.region = intern_region(std::move(region), body);
    return use;
}

// Gives names, from this index on, to the copies of their values.
void Module::name_copies(size_t first, const ModuleCloner& copier) {
    for (size_t i = first, end = named.size(); i < end; ++i)
        if (copier.has(named[i].value))
            name(copier[named[i].value], named[i].node, std::string(named[i].name));
}

// Returns the greatest number of nested calls in the body.
int Module::calls_below(const RegionBody& body) const {
    int deepest = 0;
    for (const uint32_t region : body.called)
        deepest = std::max(deepest, call_depths_[region] + 1);
    return deepest;
}

uint32_t Module::intern_region(Region region) {
    if (const auto known = region_table_.find(identity(region)); known != region_table_.end())
        return known->second;
    const RegionBody body = region.is_open() ? RegionBody{} : region_body(*this, region);
    return intern_region(std::move(region), body);
}

uint32_t Module::intern_region(Region region, const RegionBody& body) {
    const auto index = static_cast<uint32_t>(regions_.size());
    const auto [known, added] = region_table_.try_emplace(identity(region), index);
    if (!added) return known->second;
    uint8_t free_level = 0;
    if (region.kind == RegionKind::loop)
        for (const Id id : body.captured)
            free_level = std::max(free_level, inst_[id].level);
    regions_.push_back(std::move(region));
    free_levels_.push_back(free_level);
    call_depths_.push_back(calls_below(body));
    return index;
}

Id Module::apply_region(uint32_t index, std::span<const Id> args) {
    if (index == 0) return poison;
    Inst inst;
    inst.op = regions_[index].kind == RegionKind::loop ? Op::loop_ : Op::call_;
    inst.type = Type::tuple_;
    inst.extra = index;
    inst.level = free_levels_[index];
    const std::vector<Type>& params = regions_[index].params;
    bool fit = args.size() == params.size();
    for (size_t k = 0; k < args.size(); ++k) {
        if (args[k] == poison) return poison;
        inst.level = std::max(inst.level, inst_[args[k]].level);
        fit = fit && type(args[k]) == params[k];
    }
    if (!fit) {
        problem("'" + regions_[index].name + "' is given arguments of other types than it has");
        return poison;
    }
    inst.arg[0] = intern_list(args);
    return intern(inst);
}

// Returns a result of a function called with constants, if its body folds to one; otherwise no_id.
// Functions that call others are not folded: their bodies may be exponentially large.
Id Module::folded_call(uint32_t region, uint32_t k, std::span<const Id> args) {
    const std::vector<Id> constants(args.begin(), args.end());
    const auto constant = [&](Id id) { return is_constant(id); };
    if (regions_[region].is_open() || call_depths_[region] > 0) return no_id;
    if (!std::ranges::all_of(constants, constant)) return no_id;
    const Id body = regions_[region].results[k];
    ModuleCloner copier(*this, *this, false);
    for (uint32_t i = 0; i < constants.size(); ++i)
        copier.map(region_parameter(1, i, type(constants[i])), constants[i]);
    copier.run({&body, 1});
    return is_constant(copier[body]) ? copier[body] : no_id;
}

// A function's result that is a constant or one of its parameters needs no call.
Id Module::result(Id tuple, uint32_t k) {
    if (tuple == poison) return poison;
    const Inst applied = inst_[tuple];
    if (applied.op == Op::call_ && k < regions_[applied.extra].results.size())
        if (const Id folded = folded_call(applied.extra, k, lists_[applied.arg[0]])) return folded;
    const Region& region = regions_[applied.extra];
    const bool loop = applied.op == Op::loop_;
    const size_t count = loop ? region.params.size() : region.results.size();
    if (k >= count) return poison;
    if (!loop) {
        const Inst& value = inst_[region.results[k]];
        if (is_global(*this, region.results[k])) return region.results[k];
        const uint32_t first = region.is_open() ? region.first_input : 0;
        if (value.op == Op::region_param_) return lists_[applied.arg[0]][value.extra - first];
    }
    Inst inst;
    inst.op = Op::result_;
    inst.type = loop ? region.params[k] : type(region.results[k]);
    inst.level = applied.level;
    inst.arg[0] = tuple;
    inst.extra = k;
    return intern(inst);
}

Id Module::add_open_input(OpenInput input) {
    const Type type = input.type;
    open_inputs.push_back(std::move(input));
    return region_parameter(0, static_cast<uint32_t>(open_inputs.size() - 1), type);
}

Id Module::open_result(Id id) const {
    if (inst_[id].op != Op::result_ || inst_[inst_[id].arg[0]].op != Op::call_) return no_id;
    const Region& region = regions_[inst_[inst_[id].arg[0]].extra];
    return region.is_open() ? region.results[inst_[id].extra] : no_id;
}

std::vector<Id> Module::apply(const RegionUse& use, std::span<const Id> args) {
    if (use.region == 0) return {};
    std::vector<Id> all(args.begin(), args.end());
    all.insert(all.end(), use.captured.begin(), use.captured.end());
    const Id tuple = apply_region(use.region, all);
    const Region& region = regions_[use.region];
    const size_t count =
        region.kind == RegionKind::loop ? region.params.size() : region.results.size();
    std::vector<Id> results;
    for (uint32_t k = 0; k < count; ++k)
        results.push_back(result(tuple, k));
    return results;
}

}  // namespace wrinkle

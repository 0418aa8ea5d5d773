#include "ir/open_function.h"

#include <algorithm>

namespace wrinkle {

bool is_tangent(const Module& source, const Module& target, Id vector) {
    if (source.is_open_input(vector)) return target.open_inputs[source[vector].extra].tangent;
    const Id inside = source.open_result(vector);
    return inside != no_id && source[inside].op == Op::gradient_vector_;
}

OpenFunctions::OpenFunctions(Module& target, ScreenDerivatives& screen, const Module& source)
    : target_(&target), screen_(&screen), closed_(source.region_count()) {
    if (!source.has(Op::result_)) return;
    for (Id id = 1; id < source.size(); ++id) {
        if (source.open_result(id) == no_id) continue;
        const uint32_t region = source[source[id].arg[0]].extra;
        std::vector<bool>& used = closed_[region].used;
        used.resize(source.region(region).results.size(), false);
        used[source[id].extra] = true;
    }
}

bool OpenFunctions::in_function(Id wanted) {
    const Module& m = *target_;
    if (m.open_inputs.empty()) return false;
    std::vector<Id> below;
    for (auto id = static_cast<Id>(dependent_.size()); id < m.size(); ++id) {
        below.clear();
        append_dependencies(m, id, false, below);
        dependent_.push_back(
            m.is_open_input(id) ||
            std::any_of(below.begin(), below.end(), [&](Id other) { return dependent_[other]; }));
    }
    return dependent_[wanted];
}

// Returns the instructions of the body, in id order, and collects the parameters in `closed`.
std::vector<Id> OpenFunctions::body(std::span<const Id> results, Closed& closed) {
    const Module& m = *target_;
    std::vector<Id> list, captured;
    walk(results, [&](Id id, std::vector<Id>& open) {
        if (is_global(m, id)) return;
        if (m.is_open_input(id)) return closed.params.push_back(id);
        if (m[id].level == 0 && !in_function(id)) return captured.push_back(id);
        list.push_back(id);
        append_dependencies(m, id, false, open);
    });
    const auto key = [&](Id param) { return m[param].extra; };
    std::sort(closed.params.begin(), closed.params.end(),
              [&](Id a, Id b) { return key(a) < key(b); });
    closed.params.insert(closed.params.end(), captured.begin(), captured.end());
    std::sort(list.begin(), list.end());
    return list;
}

std::string OpenFunctions::name_of(Id param) const {
    constexpr std::string_view suffixes[] = {"",         "_dx",   "_dy",   "_along_x",
                                             "_along_y", "_in_x", "_in_y", "_in_z"};
    const Module& m = *target_;
    if (!m.is_open_input(param)) {
        const Inst& inst = m[param];
        return inst.op == Op::input_ ? std::string(info(input_of(inst.extra)).name) : "";
    }
    const OpenInput& input = m.open_inputs[m[param].extra];
    const auto axis = static_cast<size_t>(input.axis);
    if (axis < std::size(suffixes)) return input.name + std::string(suffixes[axis]);
    const size_t in_set = axis - static_cast<size_t>(DiffAxis::uv0_u);
    return input.name + "_in_" + (in_set % 2 == 0 ? "u" : "v") + std::to_string(in_set / 2);
}

void OpenFunctions::close(const Region& open, std::span<const Id> results, Closed& closed) {
    closed.done = true;
    closed.used.resize(results.size(), false);
    closed.member.resize(results.size(), unused);
    Region region;
    region.name = open.name;
    std::vector<Id> roots;
    for (size_t k = 0; k < results.size(); ++k) {
        if (!closed.used[k] || results[k] == poison) continue;
        closed.member[k] = static_cast<uint32_t>(roots.size());
        roots.push_back(results[k]);
        region.result_names.push_back(open.result_names[k]);
    }
    const std::vector<Id> list = body(roots, closed);
    ModuleCloner copier(*target_, *target_, false);
    copier.set_shift(1, 1);
    for (const Id param : closed.params) {
        const Type type = target_->type(param);
        const auto index = static_cast<uint32_t>(region.params.size());
        copier.map(param, target_->region_parameter(1, index, type));
        region.params.push_back(type);
        region.param_names.push_back(name_of(param));
    }
    copier.run(roots);
    for (const Id id : list)
        moved_[id] = copier[id];
    for (const Id root : roots)
        region.results.push_back(copier[root]);
    const bool whole =
        std::find(region.results.begin(), region.results.end(), poison) == region.results.end();
    if (whole && !roots.empty()) closed.region = target_->intern_region(std::move(region));
}

// Returns the value of a parameter at a call.
Id OpenFunctions::argument(Id param, uint32_t first_input, std::span<const Id> arguments) {
    if (!target_->is_open_input(param)) return param;
    uint32_t index = (*target_)[param].extra;
    const Type type = target_->type(param);
    std::vector<DiffAxis> axes;
    for (; target_->open_inputs[index].axis != DiffAxis::none;
         index = target_->open_inputs[index].of)
        axes.push_back(target_->open_inputs[index].axis);
    Id value = arguments[index - first_input];
    for (size_t i = axes.size(); i-- > 0 && value != no_id;)
        value = screen_->direction(axes[i]).jvp(value);
    return value == no_id ? target_->zero(type) : value;
}

Id OpenFunctions::call(const Module& source, Id id, std::span<const Id> mapped) {
    const Region& open = source.region(source[id].extra);
    if (!open.is_open()) return no_id;
    Closed& closed = closed_[source[id].extra];
    const auto arguments = mapped.first(open.params.size());
    if (!closed.done) close(open, mapped.subspan(open.params.size()), closed);
    std::vector<Id> args;
    for (const Id param : closed.params)
        args.push_back(argument(param, open.first_input, arguments));
    const Id tuple = target_->apply_region(closed.region, args);
    return tuple == poison ? target_->number(0) : tuple;
}

Id OpenFunctions::result(const Module& source, Id id, Id tuple) {
    if (source.open_result(id) == no_id) return no_id;
    const Closed& closed = closed_[source[source[id].arg[0]].extra];
    const uint32_t member = closed.member[source[id].extra];
    if (closed.region == 0 || member == unused) return target_->zero(source.type(id));
    return target_->result(tuple, member);
}

void OpenFunctions::finish(Module& result) const {
    for (Named& named : result.named)
        if (const auto found = moved_.find(named.value); found != moved_.end())
            named.value = found->second;
    result.open_inputs.clear();
}

}  // namespace wrinkle

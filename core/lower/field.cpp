#include "lower/field.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "ir/module_cloner.h"
#include "ir/rewrite.h"
#include "lower/sampling.h"

namespace wrinkle {
namespace {

// Most instructions of a field that each read copies.
constexpr size_t most_copied = 128;

// The part of a value that depends on a surface input.
struct Dependents {
    size_t count = 0;
    bool implicit = false;   // samples or derivatives to the next pixel are in it
    bool of_numbers = true;  // no gradients, frames or resolves are in it
};

Dependents dependents(const Module& m, Id value, Id input) {
    std::vector<Id> list, below;
    walk({&value, 1}, [&](Id id, std::vector<Id>& open) {
        list.push_back(id);
        append_dependencies(m, id, false, open);
    });
    std::sort(list.begin(), list.end());
    std::unordered_map<Id, bool> depends;
    Dependents found;
    for (const Id id : list) {
        below.clear();
        append_dependencies(m, id, false, below);
        const bool does = id == input || std::any_of(below.begin(), below.end(),
                                                     [&](Id other) { return depends[other]; });
        depends[id] = does;
        if (!does) continue;
        const Op op = m[id].op;
        const bool screen = op == Op::ddx_ || op == Op::ddy_;
        ++found.count;
        found.implicit = found.implicit || screen || op == Op::sample_;
        const bool annotation = op == Op::with_covariance_;
        found.of_numbers = found.of_numbers && (screen || annotation || !is_opaque(op));
    }
    return found;
}

}  // namespace

// Replaces implicit samples and derivatives by those along the function's parameters. Covariances
// are dropped: those of function results are not followed (ir/jacobian_by_source.h).
Id FieldReads::with_footprint(void* directions, Module& target, const Module& source, Id id,
                              std::span<const Id> mapped) {
    auto& [x, y] = *static_cast<Directions*>(directions);
    const Inst inst = source[id];
    if (inst.op == Op::ddx_) return x.jvp_or_zero(mapped[0]);
    if (inst.op == Op::ddy_) return y.jvp_or_zero(mapped[0]);
    if (inst.op == Op::with_covariance_) return mapped[0];
    if (inst.op != Op::sample_) return no_id;
    const Id uv = mapped[0], dx = x.jvp_or_zero(uv);
    return target.add(Op::sample_grad_, {uv, dx, y.jvp_or_zero(uv)}, inst.extra);
}

FieldReads::Function FieldReads::make_function(Id value, Id input, const std::string& name) {
    Module& m = *module_;
    const Dependents found = dependents(m, value, input);
    if (found.count <= most_copied || !found.of_numbers) return {true, false, {}};
    const std::vector<Type> types(found.implicit ? 3 : 1, m.type(input));
    const std::vector<Id> p = m.begin_region(
        RegionKind::function, name + (found.implicit ? "(at, at_dx, at_dy)" : "(at)"), types);
    if (!directions_)
        directions_ = {direction_along(m, DiffAxis::screen_x),
                       direction_along(m, DiffAxis::screen_y)};
    if (found.implicit) {
        directions_->x.seed(p[0], p[1]);
        directions_->y.seed(p[0], p[2]);
    }
    const Id body = substitute(m, value, {&input, 1}, p, with_footprint, &*directions_);
    return {false, found.implicit, m.end_region({&body, 1})};
}

Id FieldReads::read(Id value, SurfaceInput domain, Id at, const std::string& name) {
    if (value == poison || at == poison) return poison;
    Module& m = *module_;
    const Id input = m.input(domain);
    const auto [entry, added] = functions_.try_emplace({value, domain});
    if (added) entry->second = make_function(value, input, name);
    const auto& [copied, footprint, use] = entry->second;
    if (copied) return read_field(m, value, domain, at);
    std::vector<Id> args{at};
    if (footprint) {
        const Id varying = m[at].level == 0 ? at : input;
        args.push_back(m.add(Op::ddx_, {varying}));
        args.push_back(m.add(Op::ddy_, {varying}));
    }
    const std::vector<Id> results = m.apply(use, args);
    return results.empty() ? poison : results[0];
}

}  // namespace wrinkle

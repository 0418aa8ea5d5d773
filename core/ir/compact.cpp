#include "ir/compact.h"

#include <algorithm>

#include "ir/scopes.h"

namespace wrinkle {

std::vector<Id> values_in_scope(const Module& m, std::span<const Id> roots, int level) {
    std::vector<Id> values;
    walk(roots, [&](Id id, std::vector<Id>& open) {
        if (m[id].level < level) return;
        values.push_back(id);
        append_dependencies(m, id, false, open);
    });
    std::sort(values.begin(), values.end());
    return values;
}

Id ScopeRewriter::replace_one(void* context, Module& m, const Module&, Id id,
                              std::span<const Id> mapped) {
    const auto& replaced = static_cast<const ScopeRewriter*>(context)->replaced_;
    const Inst inst = m[id];
    const bool result = inst.op == Op::result_ && m[inst.arg[0]].op == Op::call_;
    if (!result && inst.op != Op::call_) return no_id;
    const auto found = replaced.find(result ? m[inst.arg[0]].extra : inst.extra);
    if (found == replaced.end()) return no_id;
    if (!result) {
        const std::vector<Id> args(mapped.begin(), mapped.end());
        return m.apply_region(found->second.region, args);
    }
    const auto [member, swizzle] = found->second.places[inst.extra];
    const Id value = m.result(mapped[0], member);
    return swizzle == 0 ? value : m.add(Op::swizzle_, {value}, swizzle);
}

std::vector<Id> ScopeRewriter::rewritten(std::span<const Id> roots) {
    ModuleCloner cloner(m_, m_, false);
    return rewritten(roots, cloner);
}

std::vector<Id> ScopeRewriter::rewritten(std::span<const Id> roots, ModuleCloner& cloner) {
    cloner.set_replace(replace_one, this);
    cloner.run(roots);
    for (Named& named : m_.named)
        if (cloner.has(named.value)) named.value = cloner[named.value];
    std::vector<Id> result;
    for (const Id root : roots)
        result.push_back(cloner[root]);
    return result;
}

void rewrite_scopes(Module& m, RewriteScope rewrite) {
    std::vector<uint32_t> functions;
    for_each_scope(m, [&](uint32_t region, std::span<const Id>) {
        if (region != 0) functions.push_back(region);
    });
    std::sort(functions.begin(), functions.end());
    ScopeRewriter rewriter(m);
    for (const uint32_t index : functions) {
        Region region = m.region(index);
        std::vector<Id> results = rewrite(m, rewriter.rewritten(region.results));
        if (results == region.results) continue;
        region.results = std::move(results);
        std::vector<ScopeRewriter::Place> places;
        for (uint32_t k = 0; k < region.results.size(); ++k)
            places.push_back({k, 0});
        rewriter.replace(index, m.intern_region(std::move(region)), std::move(places));
    }
    const auto outputs = rewrite(m, rewriter.rewritten(output_values(m)));
    for (size_t k = 0; k < outputs.size(); ++k)
        m.outputs[k].value = outputs[k];
}

Module compact(Module module) {
    if (module.region_count() > 1) {
        join_calls(module);
        if (module.has(Op::loop_)) rewrite_scopes(module, join_loops);
    }
    return pack(std::move(module));
}

}  // namespace wrinkle

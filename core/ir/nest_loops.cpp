#include <algorithm>

#include "ir/scopes.h"

namespace wrinkle {
namespace {

constexpr double most_in_a_row = 8;

// Returns the number of loops that the outputs run, if each call is inlined.
double loops_of(const Module& m) {
    struct Uses {
        double loops = 0;
        std::vector<uint32_t> called;  // once for each call
    };
    std::map<uint32_t, Uses> scopes;  // functions by region, callees first; then the outputs
    for_each_scope(m, [&](uint32_t region, std::span<const Id> values) {
        Uses& uses = scopes[region == 0 ? ~0U : region];
        for (const Id id : values) {
            uses.loops += m[id].op == Op::loop_;
            if (m[id].op == Op::call_) uses.called.push_back(m[id].extra);
        }
    });
    for (auto& [region, uses] : scopes)
        for (const uint32_t called : uses.called)
            uses.loops += scopes[called].loops;
    return scopes[~0U].loops;
}

uint32_t least_factor(uint32_t count) {
    uint32_t factor = 2;
    while (factor * factor <= count && count % factor != 0)
        ++factor;
    return count % factor == 0 ? factor : count;
}

// Returns the tuple of a loop over `max / n` loops of n iterations.
Id nested(Module& m, Id loop, uint32_t n) {
    const std::vector<Id> start(m.operands(loop).begin(), m.operands(loop).end());
    Region outer = m.region(m[loop].extra), inner = outer;
    ModuleCloner body(m, m, false);
    body.set_shift(outer.level, 1);
    for (const Id captured : region_body(m, inner).captured)
        body.map(captured, captured);
    body.run(inner.results);
    for (Id& result : inner.results)
        result = body[result];
    ++inner.level;
    inner.max_iterations = n;
    outer.max_iterations /= n;
    std::vector<Id> state;
    for (uint32_t k = 0; k < outer.params.size(); ++k)
        state.push_back(m.region_parameter(outer.level, k, outer.params[k]));
    const Id tuple = m.apply_region(m.intern_region(std::move(inner)), state);
    for (uint32_t k = 0; k < state.size(); ++k)
        outer.results[k + 1] = m.result(tuple, k);
    return m.apply_region(m.intern_region(std::move(outer)), start);
}

std::vector<Id> nest_in_scope(Module& m, std::vector<Id> roots) {
    ModuleCloner cloner(m, m, false);
    for (const Id id : values_in_scope(m, roots)) {
        if (m[id].op != Op::loop_) continue;
        const Region& region = m.region(m[id].extra);
        const std::vector<Id> body = values_in_scope(m, region.results, region.level);
        const uint32_t n = least_factor(region.max_iterations);
        const bool has_loops = std::any_of(body.begin(), body.end(),
                                           [&](Id value) { return m[value].op == Op::loop_; });
        if (has_loops || n == region.max_iterations || region.level > 1 + Module::max_region / 2)
            continue;
        const size_t members = region.params.size();
        const Id tuple = nested(m, id, n);
        for (uint32_t k = 0; k < members; ++k)
            cloner.map(m.result(id, k), m.result(tuple, k));
    }
    return ScopeRewriter(m).rewritten(roots, cloner);
}

}  // namespace

Module nest_loops(Module source) {
    if (!source.has(Op::loop_) || loops_of(source) <= most_in_a_row) return source;
    rewrite_scopes(source, nest_in_scope);
    return source;
}

}  // namespace wrinkle

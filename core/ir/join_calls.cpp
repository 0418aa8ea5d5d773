#include <algorithm>
#include <functional>
#include <numeric>

#include "ir/compact.h"
#include "ir/op_traits.h"
#include "ir/scopes.h"

namespace wrinkle {
namespace {

struct Function {
    std::vector<Id> body;    // in id order
    std::vector<bool> used;  // by result: some call reads it
    uint32_t family = 0;     // the first of the functions that are joined with it, or itself
};

class CallJoiner {
public:
    explicit CallJoiner(Module& m) : m_(m), rewriter_(m) {}

    // Joins once; functions that the bodies of joined functions call may then be joined too.
    // Returns false if nothing changes.
    bool run() {
        for_each_scope(m_, [&](uint32_t region, std::vector<Id> values) {
            find_calls(values);
            if (region != 0) functions_[region].body = std::move(values);
        });
        for (const auto& [first, other] : candidates_)
            if (are_related(first, other) &&
                share_work(functions_[first].body, functions_[other].body))
                join(first, other);
        std::vector<uint32_t> order;
        bool changes = false;
        for (auto& [region, function] : functions_) {
            function.family = family_of(region);
            order.push_back(function.family);
            changes = changes || function.family != region || is_reduced(region);
        }
        if (!changes) return false;
        std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
            return std::pair(m_.call_depth(a), a) < std::pair(m_.call_depth(b), b);
        });
        order.erase(std::unique(order.begin(), order.end()), order.end());
        for (const uint32_t family : order)
            write(family);
        const auto outputs = rewriter_.rewritten(output_values(m_));
        for (size_t k = 0; k < outputs.size(); ++k)
            m_.outputs[k].value = outputs[k];
        return true;
    }

private:
    using Place = ScopeRewriter::Place;

    void find_calls(std::span<const Id> values) {
        std::map<Id, uint32_t> first;  // by list of arguments
        for (const Id id : values) {
            const Inst& inst = m_[id];
            if (inst.op == Op::call_) {
                functions_[inst.extra].used.resize(m_.region(inst.extra).results.size(), false);
                const auto [known, added] = first.try_emplace(inst.arg[0], inst.extra);
                if (!added && known->second != inst.extra)
                    candidates_.emplace_back(known->second, inst.extra);
            } else if (inst.op == Op::result_ && m_[inst.arg[0]].op == Op::call_) {
                functions_[m_[inst.arg[0]].extra].used[inst.extra] = true;
            }
        }
    }

    // A sub-graph is joined with its own derivatives, not with another sub-graph.
    bool are_related(uint32_t a, uint32_t b) const {
        const Region &first = m_.region(a), &other = m_.region(b);
        return first.result_names.empty() || other.result_names.empty() ||
               first.name.starts_with(other.name) || other.name.starts_with(first.name);
    }

    // Functions of equal depth do not call each other, whatever is joined.
    void join(uint32_t a, uint32_t b) {
        a = family_of(a);
        b = family_of(b);
        if (m_.call_depth(a) == m_.call_depth(b)) parent_[std::max(a, b)] = std::min(a, b);
    }
    uint32_t family_of(uint32_t region) const {
        for (auto up = parent_.find(region); up != parent_.end() && up->second != region;
             up = parent_.find(region))
            region = up->second;
        return region;
    }

    // Returns true if a value that costs something is in both bodies.
    bool share_work(std::span<const Id> a, std::span<const Id> b) const {
        std::vector<Id> both;
        std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
        return std::any_of(both.begin(), both.end(), [&](Id id) {
            const OpTraits& cost = traits(m_[id].op);
            return m_[id].level > 0 && (m_[id].op == Op::call_ || cost.per_component > 0 ||
                                        cost.per_operand > 0 || cost.fixed > 0);
        });
    }

    // Returns true if an unjoined function loses results, or returns them as one vector.
    bool is_reduced(uint32_t region) {
        const std::vector<bool>& used = functions_[region].used;
        const auto count = static_cast<size_t>(std::count(used.begin(), used.end(), true));
        return count < used.size() || (count > 1 && fits_vector(m_.region(region)));
    }

    // Results with names of a sub-graph stay apart.
    bool fits_vector(const Region& region) const {
        int lanes = 0;
        for (const Id result : region.results)
            lanes += is_float_type(m_.type(result)) ? info(m_.type(result)).lanes : 5;
        return lanes <= 4 && region.result_names.empty();
    }

    // Writes the function of a family: the used results of all members, each once.
    void write(uint32_t family) {
        Region joined = m_.region(family);
        joined.results.clear();
        joined.result_names.clear();
        std::vector<uint32_t> members;
        for (const auto& [index, function] : functions_)
            if (function.family == family) members.push_back(index);
        // "noise" before "noise_slope", which are joined as "noise"
        std::stable_sort(members.begin(), members.end(), [&](uint32_t a, uint32_t b) {
            return m_.region(a).name.size() < m_.region(b).name.size();
        });
        std::map<uint32_t, std::vector<Place>> places;
        for (const uint32_t index : members)
            add_results(index, joined, places[index]);
        std::vector<Place> lanes(joined.results.size());
        if (joined.results.size() > 1 && fits_vector(joined)) join_results(joined, lanes);
        const uint32_t region = m_.intern_region(std::move(joined));
        for (auto& [index, of] : places) {
            for (Place& place : of)
                if (lanes[place.member].swizzle != 0) place = lanes[place.member];
            rewriter_.replace(index, region, std::move(of));
        }
    }

    void add_results(uint32_t index, Region& joined, std::vector<Place>& places) {
        const Region member = m_.region(index);
        const std::vector<Id> results = rewriter_.rewritten(member.results);
        if (joined.results.empty()) joined.name = member.name;
        for (size_t k = 0; k < results.size(); ++k) {
            places.emplace_back();
            if (!functions_[index].used[k]) continue;
            const auto known = std::ranges::find(joined.results, results[k]);
            places.back().member = static_cast<uint32_t>(known - joined.results.begin());
            if (known != joined.results.end()) continue;
            joined.results.push_back(results[k]);
            if (k < member.result_names.size())
                joined.result_names.push_back(member.result_names[k]);
        }
        if (joined.result_names.size() < joined.results.size()) joined.result_names.clear();
    }

    // Vectors first: the slope and the value of a noise are xyz and w.
    void join_results(Region& region, std::vector<Place>& lanes) {
        const auto lanes_of = [&](size_t k) { return info(m_.type(region.results[k])).lanes; };
        std::vector<size_t> order(region.results.size());
        std::iota(order.begin(), order.end(), size_t{0});
        std::ranges::stable_sort(order, std::greater(), lanes_of);
        int lane = 0;
        std::vector<Id> parts;
        for (const size_t k : order) {
            parts.push_back(region.results[k]);
            lanes[k].swizzle = lanes_of(k);
            for (int i = 0; i < lanes_of(k); ++i)
                lanes[k].swizzle |= swizzle_lane(lane++, i);
        }
        region.results = {m_.add(Op::construct_, parts, 0, vector_of(lane))};
    }

    Module& m_;
    ScopeRewriter rewriter_;
    std::map<uint32_t, Function> functions_;  // by region
    std::map<uint32_t, uint32_t> parent_;
    std::vector<std::pair<uint32_t, uint32_t>> candidates_;
};

}  // namespace

void join_calls(Module& module) {
    while (CallJoiner(module).run()) {
    }
}

}  // namespace wrinkle

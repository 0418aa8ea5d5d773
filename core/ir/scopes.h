// The scopes of a module: the bodies of its functions and the outputs.
#pragma once

#include <map>
#include <vector>

#include "ir/module_cloner.h"

namespace wrinkle {

// Returns the values at `level` and deeper that the roots need, without the bodies of called
// functions, in id order.
std::vector<Id> values_in_scope(const Module& module, std::span<const Id> roots, int level = 0);

// Visits the results of each function that the outputs need, and the outputs, once each:
// visit(region, values in its scope); region 0 is the outputs.
template <class Visit>
void for_each_scope(const Module& module, Visit visit) {
    std::vector<bool> seen(module.region_count());
    std::vector<uint32_t> open{0};
    while (!open.empty()) {
        const uint32_t region = open.back();
        open.pop_back();
        const std::vector<Id> values = values_in_scope(
            module, region == 0 ? output_values(module) : module.region(region).results);
        for (const Id id : values) {
            if (module[id].op != Op::call_ || seen[module[id].extra]) continue;
            seen[module[id].extra] = true;
            open.push_back(module[id].extra);
        }
        visit(region, values);
    }
}

// Replaces functions by others in the same module, callees first.
class ScopeRewriter {
public:
    explicit ScopeRewriter(Module& module) : m_(module) {}

    // Where a result of the replaced function is: components of a member of the new function.
    struct Place {
        uint32_t member = 0, swizzle = 0;  // swizzle 0: all components
    };
    void replace(uint32_t region, uint32_t by, std::vector<Place> places) {
        replaced_[region] = {by, std::move(places)};
    }
    // Returns the roots of a scope with the calls of replaced functions replaced.
    std::vector<Id> rewritten(std::span<const Id> roots);
    // The same with further values replaced, as mapped in the cloner.
    std::vector<Id> rewritten(std::span<const Id> roots, ModuleCloner& cloner);

private:
    struct Replacement {
        uint32_t region = 0;
        std::vector<Place> places;  // by result
    };
    static Id replace_one(void* context, Module& module, const Module&, Id id,
                          std::span<const Id> mapped);

    Module& m_;
    std::map<uint32_t, Replacement> replaced_;
};

// Rewrites the scopes, callees first: `rewrite` returns the roots of a scope in another form.
using RewriteScope = std::vector<Id> (*)(Module& module, std::vector<Id> roots);
void rewrite_scopes(Module& module, RewriteScope rewrite);

}  // namespace wrinkle

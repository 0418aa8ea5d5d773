// Copies expressions with some leaves or region levels replaced: the loop of every pass.
#pragma once

#include <algorithm>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "ir/rewrite.h"

namespace wrinkle {

// Map from ids of the source module to the ids written for them in the target module. With `count`
// > 0 it is a vector of `count` entries; with 0 it is a hash map, for few ids.
class IdMap {
public:
    explicit IdMap(size_t count) : all_(count, none) {}
    bool has(Id id) const { return all_.empty() ? few_.count(id) > 0 : all_[id] != none; }
    Id at(Id id) const { return all_.empty() ? few_.at(id) : all_[id]; }
    void set(Id id, Id written) { (all_.empty() ? few_[id] : all_[id]) = written; }

private:
    static constexpr Id none = ~0U;
    std::vector<Id> all_;
    std::unordered_map<Id, Id> few_;
};

class ModuleCloner {
public:
    // `into_functions`: the bodies of called functions are copied too, as a copy of a complete
    // module requires. Functions are closed, so a copy within one module (source and target are the
    // same) does not need it.
    ModuleCloner(Module& target, const Module& source, bool into_functions)
        : target_(&target),
          source_(&source),
          into_functions_(into_functions),
          ids_(into_functions ? source.size() : 0) {}

    void map(Id from, Id to) { ids_.set(from, to); }
    void set_replace(Replace replace, void* context) {
        replace_ = replace;
        context_ = context;
    }
    // Adds `shift` to the level of regions at level `first` and deeper.
    void set_shift(int first, int shift) {
        first_level_ = first;
        shift_ = shift;
    }

    // Names of values of the source, sorted by value; run() gives them to the copies.
    void carry_names(std::vector<Named> names) { names_ = std::move(names); }

    void run(std::span<const Id> roots);
    // Precondition: `id` is mapped or the roots of run() need it.
    Id operator[](Id id) const { return ids_.at(id); }
    bool has(Id id) const { return ids_.has(id); }

private:
    std::vector<Id> reachable_ids(std::span<const Id> roots) const;
    int shifted(int level) const { return level >= first_level_ ? level + shift_ : level; }
    bool is_kept(Id id) const { return ids_.at(id) == id; }
    Id replaced(Id id, std::span<const Id> args);
    Id write(Id id);
    Id write_apply(const Inst& inst, std::span<const Id> args);
    Id write_leaf(Inst inst);
    void give_names(Id id);

    Module* target_;
    const Module* source_;
    bool into_functions_;
    int first_level_ = 1;
    int shift_ = 0;
    Replace replace_ = nullptr;
    void* context_ = nullptr;
    IdMap ids_;
    std::vector<Named> names_;
    size_t next_name_ = 0;
    std::vector<Id> args_;  // scratch: operands of the instruction being written come first
};

// Calls visit(id, open) once for each root and for each id that it appends to `open`, depth first
// and from left to right.
template <class Visit>
void walk(std::span<const Id> roots, Visit visit) {
    std::unordered_set<Id> seen{no_id};
    std::vector<Id> open(roots.rbegin(), roots.rend());
    while (!open.empty()) {
        const Id id = open.back();
        open.pop_back();
        const auto first = static_cast<std::ptrdiff_t>(open.size());
        if (seen.insert(id).second) visit(id, open);
        std::reverse(open.begin() + first, open.end());
    }
}

// Returns true for constants, parameters and image sizes: generated code has them outside every
// function, and any function may read them.
bool is_global(const Module& module, Id id);

// Returns true if `value` is computed from global values only, without a texture read, so that a
// function can compute it without a parameter.
bool is_of_globals(const Module& module, Id value);

// Appends the ids that an instruction reads: its operands, its base, and the results of the region
// that it applies (of a called function only with `into_functions`).
void append_dependencies(const Module& module, Id id, bool into_functions, std::vector<Id>& out);

}  // namespace wrinkle

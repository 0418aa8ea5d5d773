// Writing expressions again with some of their leaves or levels changed: the loop below every pass.
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "ir/rewrite.h"

namespace wrinkle {

// What was written for the ids of a module; `count` of them are kept in a list, 0 keeps few.
class Written {
public:
    explicit Written(size_t count) : all_(count, none) {}
    bool has(Id id) const { return all_.empty() ? few_.count(id) > 0 : all_[id] != none; }
    Id at(Id id) const { return all_.empty() ? few_.at(id) : all_[id]; }
    void set(Id id, Id written) { (all_.empty() ? few_[id] : all_[id]) = written; }

private:
    static constexpr Id none = ~0U;
    std::vector<Id> all_;
    std::unordered_map<Id, Id> few_;
};

class Copier {
public:
    // `into_functions`: a whole module is written again, the bodies of called functions too. They
    // are closed, so within one module, source and target alike, there is no need.
    Copier(Module& target, const Module& source, bool into_functions)
        : target_(&target),
          source_(&source),
          into_functions_(into_functions),
          written_(into_functions ? source.size() : 0),
          renamed_(into_functions ? source.size() : 0, false) {}

    void map(Id from, Id to) { written_.set(from, to); }
    void set_replace(Replace replace, void* context) {
        replace_ = replace;
        context_ = context;
    }
    // Regions at `first` and deeper move by `shift` levels.
    void set_shift(int first, int shift) {
        first_level_ = first;
        shift_ = shift;
    }

    void run(std::span<const Id> roots);
    // Of something the roots needed.
    Id operator[](Id id) const { return written_.at(id); }
    bool has(Id id) const { return written_.has(id); }

private:
    std::vector<Id> few_needed(std::span<const Id> roots) const;
    int shifted(int level) const { return level >= first_level_ ? level + shift_ : level; }
    // Whether what was written for it, and for all below it, is the same but for names.
    bool is_kept(Id id) const { return into_functions_ ? renamed_[id] : written_.at(id) == id; }
    Id replaced(Id id, std::span<const Id> args);
    Id write_for(Id id);
    Id write(Id id);
    Id write_apply(const Inst& inst, std::span<const Id> args);
    Id write_leaf(const Inst& inst);

    Module* target_;
    const Module* source_;
    bool into_functions_;
    int first_level_ = 1;
    int shift_ = 0;
    Replace replace_ = nullptr;
    void* context_ = nullptr;
    Written written_;
    std::vector<uint8_t> renamed_;  // of a whole module: written as it was, and so all below it
    std::vector<Id> args_;          // those of what is being written stand first
};

// Stands outside every function in generated code and may be read from anywhere.
bool is_global(const Module& module, Id id);

// What an instruction reads: its operands, its base, and what the region it applies gives.
void append_dependencies(const Module& module, Id id, bool into_functions, std::vector<Id>& out);

}  // namespace wrinkle

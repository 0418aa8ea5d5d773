// What the material on the canvas costs, node by node: of the text that the preview runs, with its
// values as uniforms. A sub-graph's nodes count for the node that stands for it.
//
// Counted is what `wrinkle compile --cost --params uniform` counts (cost/measure.h). That runs
// compilers, for a part of a second or longer, so it has a thread of its own (CostCounter) and only
// follows the text. An estimate (ir/cost.h) is there with the text; it stands until the first count
// has come, and in place of one where none can be made, with the reason why.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cost/spirv_count.h"
#include "editor/worker.h"
#include "graph/document.h"
#include "ir/module.h"

namespace wrinkle::editor {

struct Price {
    ShaderCost cost;
    size_t texture_units = 0;
};

struct Costs {
    bool estimated = false;
    std::string why;           // nothing better than an estimate can be had; one sentence
    Price total;               // with what the outputs alone need
    std::vector<Price> nodes;  // by index in the document
};

// Beyond this estimate of numbers nothing is counted: the compilers would take many seconds.
inline constexpr uint32_t most_counted = 20'000;

Costs estimate_costs(const Module& module, const Document& document);
Costs count_costs(const Module& module, const Document& document);  // or an estimate, and why

struct CostJob {
    uint64_t version = 0;  // of the compilation
    std::shared_ptr<const Module> module;
    Document document;
};
struct CountedCosts {
    uint64_t version = 0;
    Document document;
    Costs costs;
};
CountedCosts count(CostJob job);
using CostCounter = Worker<CostJob, CountedCosts>;

// "1 read · 14 ops", of an estimate "~1 read · ~14 ops"; "14 ops" where nothing is read.
std::string in_words(const Price& price, bool estimated);
// All that is known, in lines: "14 numbers computed, 2 of them divisions", ...
std::string in_full(const Price& price, const Costs& of);

}  // namespace wrinkle::editor

// Cost of the material on the canvas, per node: of the shader that the preview runs, with its
// values as uniforms. Costs of a sub-graph's nodes are added to its node in the document.
//
// The count equals that of `wrinkle compile --cost --params uniform` (cost/report.h). It runs
// compilers for a fraction of a second or longer on its own thread (CostCounter) and is repeated
// only if the generated source changes. Every compilation has an estimate (ir/cost.h), which is
// shown until the first count is done, or with a reason if nothing can be counted.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cost/spirv_count.h"
#include "editor/model/worker.h"
#include "graph/document.h"
#include "ir/side_tables.h"

namespace wrinkle::editor {

struct Price {
    ShaderCost cost;
    size_t texture_units = 0;
};

struct Costs {
    uint64_t version = 0;  // version of the compilation
    Document document;
    bool estimated = false;
    std::string why;           // one sentence: why only an estimate is available
    Price total;               // includes code that only the outputs need
    std::vector<Price> nodes;  // by index in `document`
};

// Modules with a larger estimate of ALU operations are not counted: the compilers would take many
// seconds.
inline constexpr uint32_t max_counted = 20'000;

Costs estimate_costs(const Module& module, const Document& document);
Costs count_costs(const Module& module, const Document& document);  // or an estimate, and why

struct CostJob {
    uint64_t version = 0;  // version of the compilation
    std::shared_ptr<const Module> module;
    Document document;
};
Costs count(const CostJob& job);
using CostCounter = Worker<CostJob, Costs>;

// "1 read · 14 ops"; of an estimate "~1 read · ~14 ops"; "14 ops" if nothing is read.
std::string in_words(const Price& price, bool estimated);
// All known figures, in lines: "14 numbers computed, of these 2 divisions and 1 transcendental",
// ...
std::string in_full(const Price& price, const Costs& of);

}  // namespace wrinkle::editor

// Budget of a regression case: limits of the cost of its shader. The numbers are exact counts
// (cost/report.h), but for compile_ms.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/material_run.h"
#include "report/results.h"

namespace wrinkle::cli {

// A key of "budget" and its limit.
struct BudgetLimit {
    std::string name;
    double limit = 0;
};

// "alu", ..., "texture_units" as in `wrinkle compile --cost --json`; "text_bytes": size of the
// function form; "compile_ms": time to compile and emit it.
std::vector<std::string> budget_names();

struct CompiledCost {
    const Module& module;
    size_t text_bytes = 0;
    double compile_ms = 0;
};

// Returns one number per limit; `node` is the one with the largest part. Returns std::nullopt and
// sets `why` if the cost cannot be counted (measure_cost()).
std::optional<std::vector<report::Measured>> measure_budget(const std::vector<BudgetLimit>& budget,
                                                            const CompiledCost& compiled,
                                                            std::string& why);

}  // namespace wrinkle::cli

// Output of `wrinkle compile --cost`.
#pragma once

#include <span>
#include <string>

#include "base/diagnostics.h"
#include "cost/measure.h"

namespace wrinkle::cli {

// Returns the cost report as a table or as JSON; "" and an error on failure.
std::string cost_of(const Module& module, Differentials differentials, bool json,
                    const std::string& file, Diagnostics& diagnostics);

// Printed output: the table of one graph; for several, each table below its file name. With `json`:
// {"version": 1, "graphs": [{"file", "cost": to_json(CostReport)}]}.
struct GraphCost {
    std::string file, report;
};
std::string printed_costs(std::span<const GraphCost> costs, bool several, bool json);

}  // namespace wrinkle::cli

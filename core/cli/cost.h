// What `wrinkle compile` says of a shader's cost.
#pragma once

#include <span>
#include <string>

#include "base/diagnostics.h"
#include "cost/measure.h"

namespace wrinkle::cli {

// The report of --cost, as a table or as JSON; "" with an error.
std::string cost_of(const Module& module, Differentials differentials, bool json,
                    const std::string& file, Diagnostics& diagnostics);

// What is printed: of one graph its table, of several each below the name of its file. With `json`
// {"version": 1, "graphs": [{"file", "cost": to_json(CostReport)}]}.
struct GraphCost {
    std::string file, report;
};
std::string printed_costs(std::span<const GraphCost> costs, bool several, bool json);

}  // namespace wrinkle::cli

#include "cli/cost.h"

#include "base/printable.h"
#include "base/text.h"

namespace wrinkle::cli {

std::string cost_of(const Module& module, Differentials differentials, bool json,
                    const std::string& file, Diagnostics& diagnostics) {
    std::string why;
    const auto report = measure_cost(module, differentials, why);
    if (report) return json ? to_json(*report) : to_text(*report);
    Diagnostic problem;
    problem.where.file = file;
    problem.message = "its cost cannot be counted: " + why;
    diagnostics.add(problem);
    return {};
}

std::string printed_costs(std::span<const GraphCost> costs, bool several, bool json) {
    std::string text;
    for (const GraphCost& each : costs) {
        if (json)
            text += (text.empty() ? "\n" : ",\n") + ("{\"file\": " + json_quoted(each.file)) +
                    ", \"cost\":\n" + each.report + "}";
        else
            text += (text.empty() ? "" : "\n") + (several ? printable(each.file) + "\n" : "") +
                    each.report;
    }
    return json ? "{\"version\": 1, \"graphs\": [" + text + "\n]}\n" : text;
}

}  // namespace wrinkle::cli

#include "cli/test_budget.h"

#include <algorithm>

#include "base/text.h"
#include "cost/report.h"

namespace wrinkle::cli {
namespace {

constexpr const char* text_bytes = "text_bytes";
constexpr const char* compile_ms = "compile_ms";

// Returns the count of that name; 0 if there is none.
uint64_t count_of(const std::vector<NamedCount>& counts, const std::string& name) {
    const auto found = std::ranges::find(counts, name, &NamedCount::name);
    return found == counts.end() ? 0 : found->count;
}

// Returns the node with the largest part of a count; "" if no node has any.
std::string largest_part(const CostReport& report, const std::string& name) {
    std::string node;
    uint64_t largest = 0;
    for (const NodeCost& each : report.nodes) {
        CostReport part;
        part.total = each.cost;
        part.texture_units = each.texture_units;
        const uint64_t count = count_of(named_counts(part), name);
        if (count > largest) node = each.node;
        largest = std::max(largest, count);
    }
    return node;
}

}  // namespace

std::vector<std::string> budget_names() {
    std::vector<std::string> names;
    for (const NamedCount& count : named_counts({}))
        names.emplace_back(count.name);
    names.insert(names.end(), {text_bytes, compile_ms});
    return names;
}

std::optional<std::vector<report::Measured>> measure_budget(const std::vector<BudgetLimit>& budget,
                                                            const CompiledCost& compiled,
                                                            std::string& why) {
    std::vector<report::Measured> measured;
    std::optional<CostReport> report;
    for (const BudgetLimit& each : budget) {
        report::Measured& number = measured.emplace_back();
        number.name = each.name;
        number.limit = each.limit;
        if (each.name == text_bytes) {
            number.value = static_cast<double>(compiled.text_bytes);
        } else if (each.name == compile_ms) {
            number.value = compiled.compile_ms;
        } else {
            if (!report) report = measure_cost(compiled.module, Differentials::screen, why);
            if (!report) return {};
            number.value = static_cast<double>(count_of(named_counts(*report), each.name));
            number.node = largest_part(*report, each.name);
        }
        number.actual = shortest(number.value);
        number.expected = shortest(each.limit);
    }
    return measured;
}

}  // namespace wrinkle::cli

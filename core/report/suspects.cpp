#include "report/suspects.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace wrinkle::report {
namespace {

constexpr size_t shown = 3;

}  // namespace

std::vector<Suspect> suspects(const std::vector<CaseUses>& cases, double least) {
    const auto all_failed = static_cast<double>(std::ranges::count(cases, true, &CaseUses::failed));
    if (all_failed == static_cast<double>(cases.size())) return {};  // no case to compare with
    std::map<std::string, Suspect> by_name;
    for (const CaseUses& each : cases)
        for (const std::string& name : std::set(each.uses.begin(), each.uses.end())) {
            Suspect& suspect = by_name[name];
            suspect.name = name;
            ++(each.failed ? suspect.failed : suspect.passed);
        }
    std::vector<Suspect> found;
    for (auto& [name, suspect] : by_name) {
        const auto all = static_cast<double>(suspect.failed + suspect.passed);
        suspect.score = static_cast<double>(suspect.failed) / std::sqrt(all_failed * all);
        if (suspect.failed > 1 && suspect.score >= least) found.push_back(suspect);
    }
    std::ranges::stable_sort(found, std::greater(), &Suspect::score);
    found.resize(std::min(found.size(), shown));
    return found;
}

std::vector<std::string> likely_causes(const std::vector<CaseUses>& cases) {
    const auto failed = static_cast<size_t>(std::ranges::count(cases, true, &CaseUses::failed));
    std::vector<std::string> clauses;
    for (const Suspect& each : suspects(cases))
        clauses.push_back(each.name + ": in " + std::to_string(each.failed) + " of " +
                          std::to_string(failed) + " failed and " + std::to_string(each.passed) +
                          " of " + std::to_string(cases.size() - failed) + " passed cases");
    return clauses;
}

}  // namespace wrinkle::report

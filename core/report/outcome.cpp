#include "report/outcome.h"

#include "base/text.h"
#include "report/repository.h"
#include "report/text_diff.h"

namespace wrinkle::report {
namespace {

constexpr size_t max_details = 20'000;  // bytes, of the difference of a text

}  // namespace

Outcome outcome_of(const Check& check, const CiOptions& options) {
    switch (check.status) {
        case Status::passed:
            return Outcome::passed;
        case Status::error:
            return Outcome::error;
        case Status::added:
            return options.added_fails ? Outcome::failure : Outcome::skipped;
        default:
            return Outcome::failure;
    }
}

std::string message_of(const Check& check) {
    if (!check.message.empty()) return check.message;
    if (check.status == Status::added) return "has no baseline yet";
    return std::string(name_of(check.status));
}

std::string file_of(const Check& check, const CiOptions& options) {
    return check.file.empty() ? "" : path_in_repository(check.file, options.root);
}

std::string details_of(const Check& check) {
    std::string text;
    if (!check.expected.empty()) text += check.expected + "\n";
    for (const Measured& each : check.measured) {
        if (each.within() && check.status != Status::added) continue;
        text += each.name + (each.node.empty() ? "" : " (" + each.node + ")") + ": ";
        if (!each.expected.empty()) text += "expected " + each.expected + ", ";
        if (!each.actual.empty()) text += "found " + each.actual + ", ";
        const std::string unit = each.unit.empty() ? "" : " " + each.unit;
        text += "measured " + shortest(each.value) + unit + ", limit " + shortest(each.limit) +
                unit + "\n";
    }
    if (check.kind == CheckKind::text && check.status == Status::failed)
        for (const DiffLine& line : diff_lines(check.expected_text, check.actual_text)) {
            text += " -+~"[static_cast<size_t>(line.kind)] + std::string(line.text) + "\n";
            if (text.size() > max_details) break;
        }
    if (!check.baseline.empty()) text += "baseline: " + check.baseline + "\n";
    return text;
}

std::vector<Check> checks_of_run(const Results& results) {
    std::vector<Check> checks;
    for (const std::string& problem : results.problems) {
        Check check;
        check.test = "wrinkle test";
        check.name = "run " + std::to_string(checks.size() + 1);
        check.status = Status::error;
        check.message = problem;
        checks.push_back(std::move(check));
    }
    return checks;
}

}  // namespace wrinkle::report

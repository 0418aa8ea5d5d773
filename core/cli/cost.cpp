#include "cli/cost.h"

#include "cost/report.h"

namespace wrinkle::cli {

void judge_texture_units(const Reflection& reflection, const std::string& file, bool strict,
                         Diagnostics& diagnostics) {
    const std::string problem = texture_unit_problem(reflection);
    if (problem.empty()) return;
    Diagnostic found;
    found.severity = strict ? Severity::error : Severity::warning;
    found.where.file = file;
    found.message = problem;
    found.expected = "put several masks into the channels of one picture, or fewer layers";
    diagnostics.add(found);
}

}  // namespace wrinkle::cli

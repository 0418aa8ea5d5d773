// A check as CI formats describe it; internal to core/report.
#pragma once

#include <string>
#include <vector>

#include "report/ci_formats.h"

namespace wrinkle::report {

enum class Outcome : uint8_t { passed, skipped, failure, error };

Outcome outcome_of(const Check& check, const CiOptions& options);
std::string message_of(const Check& check);  // never empty
// Lines: the remedy, each number beyond its limit, the first line that differs, the baseline.
std::string details_of(const Check& check);
// Returns the test file relative to the repository, "" if there is none.
std::string file_of(const Check& check, const CiOptions& options);
// Problems of the entire run as checks of the test "wrinkle test".
std::vector<Check> checks_of_run(const Results& results);

}  // namespace wrinkle::report

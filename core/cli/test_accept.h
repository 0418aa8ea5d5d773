// Approval: writes the results of a run to the baselines that differ. Works from the report of the
// run (report/results.h and the images of its folder).
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/session.h"
#include "cli/test_case.h"
#include "report/results.h"

namespace wrinkle::cli {

// Returns the hash of the program, the settings of a case and the files of case_inputs(), without
// baselines: if it changes, a result is out of date. Files that cannot be read count as empty.
std::string hash_of_inputs(const TestCase& test, const Registry& registry,
                           const CommonOptions& common);

// Returns true for checks that differ from a baseline that can be written or removed: not for those
// that could not run, and not for budgets, which are limits and not results.
bool is_pending(const report::Check& check);

// Returns true if a name of --accept selects the check: "new", "changed", "deleted", "all", an id,
// or the beginning of ids up to a '/' or, for the entries of a case, a '.'.
bool selects(std::string_view name, const report::Check& check);

struct Acceptance {
    std::vector<std::string> written;  // files, in the order of the checks
    std::vector<std::string> refused;  // a sentence per check, or file outside of the root
    std::string environment;           // why a file could not be written, one sentence, or ""
};

// Accepts the pending checks for which `accepts` returns true; accepted checks become passed.
// `folder` is that of the report. Refuses a check if the inputs of its case changed after the run.
Acceptance accept(report::Results& results, const std::filesystem::path& folder,
                  const std::function<bool(const report::Check&)>& accepts,
                  const Registry& registry, const CommonOptions& common);

}  // namespace wrinkle::cli

// Results in the formats of CI systems (docs/ci.md). Names are the same in every run. In JUnit,
// characters that XML does not allow are U+FFFD and terminal sequences are removed; TAP and
// GitHub's commands escape characters that cannot be printed (base/printable.h).
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "report/results.h"

namespace wrinkle::report {

struct CiOptions {
    // Returns the path of an image of the results as it is written; empty: no attachments.
    std::function<std::string(const std::string&)> attachment;
};

// JUnit XML as GitLab, Jenkins, GitHub actions and Azure DevOps read it: one <testsuite> per case,
// one <testcase> per check. A difference is a <failure>, a check that could not run an <error>, and
// a new check <skipped>, unless it fails. The attachment of a check is its joined image.
std::string junit(const Results& results, const CiOptions& options);

// TAP version 14.
std::string tap(const Results& results);

// Commands of GitHub Actions, one line each: "::error file=...::...". At most 10, because GitHub
// shows no more errors of a step: errors first, then the worst failures; the last has the number of
// the rest. Files are relative to `root`, that of the repository (path_in_repository()).
std::string github_annotations(const Results& results, const std::filesystem::path& root);

}  // namespace wrinkle::report

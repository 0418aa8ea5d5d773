// Runs the cases of a test file and holds them to their baselines. Writes no baseline: a image
// that is not passed is written to the report's folder, from where it can be accepted
// (cli/test_accept.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/cache.h"
#include "cli/session.h"
#include "cli/test_case.h"
#include "report/results.h"
#include "report/suspects.h"

namespace wrinkle::cli {

struct TestSettings {
    const Registry& registry;
    const CommonOptions& common;
    std::filesystem::path folder;  // the report's
    Cache* images = nullptr;       // images of earlier runs; may be null
};

struct TestOutcome {
    std::vector<report::Check> checks;
    std::vector<report::CaseUses> uses;  // one per case that could be compiled
    Diagnostics problems;                // from reading and compiling
    std::string environment;  // why a image could not be drawn or written, one sentence, or ""
    std::string driver;       // OpenGL's; "" if no image was drawn
};

// Runs all cases of a file. A case that cannot run is one check with Status::error. Thread-safe.
TestOutcome run_test_file(const TestFile& file, const TestSettings& settings);

}  // namespace wrinkle::cli

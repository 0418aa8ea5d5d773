// Report of a test run: a folder with index.html, results.json and the images of checks that are
// not passed. Its default is .wrinkle/test below the working folder, which Git ignores.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/results.h"

namespace wrinkle::cli {

inline constexpr const char* default_report = ".wrinkle/test";
inline constexpr const char* page_file = "index.html";
inline constexpr const char* results_file = "results.json";

// Returns the time now, ISO 8601 in UTC; that of SOURCE_DATE_EPOCH (reproducible-builds.org) if the
// variable is set.
std::string time_of_report();
// Sets all durations to 0 if SOURCE_DATE_EPOCH is set, so that reports are the same in every run.
void clear_durations_if_reproducible(report::Results& results);

// Returns false if links lead a write to `file` out of the folder, or the default folder out of the
// working folder: a checkout may contain such links.
bool is_in_report(const std::filesystem::path& folder, const std::filesystem::path& file);

// Creates the folder; the default one with a .gitignore. Returns false and the reason in `why` on
// failure.
bool make_report_folder(const std::filesystem::path& folder, std::string& why);

// Writes index.html and results.json, and removes images of an earlier run. Returns false and the
// reason in `why` on failure.
bool write_report(const report::Results& results, const std::filesystem::path& folder,
                  std::string& why);

// Removes a report of an earlier run; other files of the folder remain.
void remove_report(const std::filesystem::path& folder);

// Appends the checks, durations and problems of a shard's report to `results`, and copies its
// images into `folder`, without those that cannot be read. Returns false and the reason in `why` on
// failure.
bool merge_report(const std::filesystem::path& shard, const std::filesystem::path& folder,
                  report::Results& results, std::string& why);

// One line per check that is not passed: "FAIL graphs/rings/points/2: output ... (FILE:LINE)".
std::string failures_text(const report::Results& results);

// "12 passed, 1 failed", and the numbers of new and deleted baselines that are not 0. Checks that
// could not run count as failed.
std::string counts_text(const report::Results& results);

}  // namespace wrinkle::cli

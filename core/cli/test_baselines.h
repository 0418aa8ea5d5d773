// Golden files that no case reads: those of a case or a graph that was renamed or removed.
#pragma once

#include <filesystem>
#include <set>
#include <vector>

#include "cli/test_case.h"
#include "report/results.h"

namespace wrinkle::cli {

// Returns the files NAME.glsl and NAME.png in the folder `golden` of each folder that no case of
// `files` reads, sorted. A folder with a test file that has errors has none. Precondition: `files`
// has all test files of the folders.
std::vector<std::filesystem::path> unread_baselines(const std::set<std::filesystem::path>& folders,
                                                    const std::vector<TestFile>& files);

// Returns the same of one folder, and reads its test files.
std::vector<std::filesystem::path> unread_baselines(const std::filesystem::path& folder);

// Returns one check with Status::deleted per file.
std::vector<report::Check> deleted_checks(const std::vector<std::filesystem::path>& files);

}  // namespace wrinkle::cli

// Golden files that no case reads: those of a case or a graph that was renamed or removed.
#pragma once

#include <filesystem>
#include <vector>

#include "report/results.h"

namespace wrinkle::cli {

// Returns the files NAME.glsl and NAME.png in the folder `golden` of each folder that no case of
// the folder's test files reads, sorted. A folder with a test file that has errors has none.
std::vector<std::filesystem::path> unread_baselines(
    const std::vector<std::filesystem::path>& folders);

// Returns one check with Status::deleted per file.
std::vector<report::Check> deleted_checks(const std::vector<std::filesystem::path>& files);

}  // namespace wrinkle::cli

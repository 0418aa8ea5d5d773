// Cases of a report in the order of the page, and the parts of checks that are in the page.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "report/markup.h"
#include "report/results.h"

namespace wrinkle::report {

// A case with checks that are not passed.
struct Case {
    std::string name;
    std::vector<size_t> checks;     // indices in the results, in their order
    std::vector<size_t> differing;  // those that are not passed
};

// Returns cases with errors first, then the others by how far their checks exceed their limits.
std::vector<Case> cases_by_severity(const Results& results);

struct Contents {
    std::vector<CheckParts> parts;                   // for each check of the results
    size_t lines_left_out = 0, images_left_out = 0;  // checks
};

// Returns the lines and the images of as many checks as `max_bytes` allows, in the order of the
// cases, lines before images. `fixed` bytes of the page are in use; names, messages and numbers of
// all checks are always in it.
Contents contents_within(const Results& results, const std::vector<Case>& cases,
                         const std::filesystem::path& folder, uint64_t max_bytes, uint64_t fixed);

}  // namespace wrinkle::report

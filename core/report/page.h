// Report of a test run as one HTML file: opens from the file system and loads nothing.
//
// Everything is in the markup: a check that is not passed has its message, numbers, text difference
// and images; passed checks are names. The script adds filters, keys and image views. Texts and
// names are escaped; the policy of the page allows only its own script and inlined images.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "report/results.h"

namespace wrinkle::report {

inline constexpr uint64_t max_page_bytes = uint64_t{32} << 20;

// Images of the results are files in `folder`. The images of the checks that exceed their limits
// least are left out if the page would have more than `max_bytes`; the page names how many. An
// image that cannot be read is named instead.
std::string page(const Results& results, const std::filesystem::path& folder,
                 uint64_t max_bytes = max_page_bytes);

}  // namespace wrinkle::report

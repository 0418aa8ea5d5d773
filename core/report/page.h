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

// Images of the results are files in `folder`. Differences of texts, then images, are added in the
// order of the page, and each that would exceed `max_bytes` is left out; the page names how many.
// Names, messages and numbers are always there, so that a page can be larger. An image that cannot
// be read is named instead.
std::string page(const Results& results, const std::filesystem::path& folder,
                 uint64_t max_bytes = max_page_bytes);

}  // namespace wrinkle::report

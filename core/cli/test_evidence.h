// Images of a check in a report: expected, actual, the map of the difference, and all side by side.
#pragma once

#include <filesystem>
#include <string>

#include "cli/test_compare.h"
#include "report/results.h"

namespace wrinkle::cli {

struct CheckImages {
    const Image* expected = nullptr;  // may be null
    const Image& actual;
    const ImageComparison& compared;  // empty without `expected`
};

// Writes the images below the report's folder, as NAME.png, and names them in the check. Returns
// false and the reason in `why` on failure.
bool save_images(const CheckImages& images, const std::filesystem::path& folder,
                 const std::string& name, report::Check& check, std::string& why);

}  // namespace wrinkle::cli

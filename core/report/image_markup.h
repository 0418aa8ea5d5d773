// HTML of the images of a check.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "report/results.h"

namespace wrinkle::report {

struct InlinedImage {
    std::string uri;  // "data:image/png;base64,..."; "" without an image
    uint32_t width = 0, height = 0;
};

struct InlinedImages {
    InlinedImage expected, actual, map;
    size_t bytes() const { return expected.uri.size() + actual.uri.size() + map.uri.size(); }
};

// Reads the images of a check. An image that is not a PNG file in `folder` has no uri.
InlinedImages inlined_images(const Check& check, const std::filesystem::path& folder);

// Names of the two sides of a check: "Expected" and "Actual", or "Before" and "After".
inline const char* expected_name(const Check& check) {
    return check.status == Status::changed ? "Before" : "Expected";
}
inline const char* actual_name(const Check& check) {
    return check.status == Status::changed ? "After" : "Actual";
}

// Figures of the images; an image without uri is named.
std::string images_markup(const Check& check, const InlinedImages& images);

}  // namespace wrinkle::report

// HTML of the parts of a report.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "report/results.h"

namespace wrinkle::report {

// Returns the text on one line, with characters that cannot be printed escaped (base/printable.h),
// for use in an element or in an attribute with double quotes.
std::string html(std::string_view text);

// Images of one check as data URIs; "" if there is none.
struct InlinedImages {
    std::string expected, actual, map;
    size_t bytes() const { return expected.size() + actual.size() + map.size(); }
};
InlinedImages inlined_images(const Check& check, const std::filesystem::path& folder);

// One check that is not passed: a <details> element.
std::string check_markup(const Check& check, const InlinedImages& images, bool is_open);

}  // namespace wrinkle::report

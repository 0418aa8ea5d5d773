// HTML of the parts of a report.
#pragma once

#include <string>
#include <string_view>

#include "report/image_markup.h"
#include "report/results.h"

namespace wrinkle::report {

// Returns the text on one line, with characters that cannot be printed escaped (base/printable.h),
// for use in an element or in an attribute with double quotes.
std::string html(std::string_view text);

// "12", "0.04871".
std::string number(double value);

// The large parts of a check, which a page leaves out if it would be too large; "" for none.
struct CheckParts {
    std::string lines;  // diff_markup()
    std::string nodes;  // nodes of these lines, separated by spaces
    InlinedImages images;
};

// One check that is not passed: a <details> element. Its body is in a <noscript> element, which a
// browser with scripts reads as one text: the script of the page makes elements of it when needed.
std::string check_markup(const Check& check, const CheckParts& parts, bool is_open);

}  // namespace wrinkle::report

// HTML of a case: its heading with the cost of its shader, and a table of its points by outputs.
#pragma once

#include <string>

#include "report/page_contents.h"
#include "report/results.h"

namespace wrinkle::report {

// "passed", or "same" between two graphs.
const char* passed_name(const Results& results);

// The name of the case, each cost with its budget (between two graphs: before and after), and the
// names of the checks that passed.
std::string heading_markup(const Results& results, const Case& each);

// A <div> with a <details> element, a row per point and a column per output; "" for fewer than two
// points, or if none has numbers. Its body is in <noscript>, as that of a check.
std::string points_markup(const Results& results, const Case& each, bool is_open);

}  // namespace wrinkle::report

// HTML of the difference of two texts.
#pragma once

#include <string>
#include <vector>

#include "report/results.h"

namespace wrinkle::report {

struct DiffMarkup {
    std::string table;               // "" if the check has no text
    std::vector<std::string> nodes;  // nodes of added lines, each once, in the order of the lines
};

// Lines that differ with their nodes; the part of a line that changed is in a <mark> element. At
// most `max_rows` lines.
DiffMarkup diff_markup(const Check& check, size_t max_rows = 2000);

}  // namespace wrinkle::report

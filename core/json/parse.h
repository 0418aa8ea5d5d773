// Text to Value, with every problem at its place.
//
// Reported: syntax errors (NaN, Infinity, comments and trailing commas among them), numbers out of
// range, invalid UTF-8, nesting deeper than the limit: each of these ends the reading, and what
// stood before it is returned with the cut containers marked `cut_off`. Duplicate keys are reported
// too and do not end it. A byte order mark is skipped. No recursion; time linear in the text.
#pragma once

#include <string>

#include "json/value.h"

namespace wrinkle::json {

struct ParseLimits {
    uint32_t depth = 64;  // how deep arrays and objects may nest
};

struct Parsed {
    Value root;  // null when nothing could be read
    bool complete = false;
};

// `file` names the text in locations.
Parsed parse(std::string text, std::string file, Diagnostics& diagnostics, ParseLimits limits = {});

}  // namespace wrinkle::json

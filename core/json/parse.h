// Parses text to a Value; every error has its location in the text.
//
// Reported: syntax errors (including NaN, Infinity, comments and trailing commas), numbers out of
// range, invalid UTF-8, nesting deeper than the limit. Each of these stops the parser; the values
// before it are returned, with incomplete containers marked `cut_off`. Duplicate keys are reported
// and do not stop the parser. A byte order mark is skipped. No recursion; linear time in the size
// of the text.
//
// nlohmann_json is the lexer and the grammar (its SAX interface). This module adds to its events
// the locations of all values, the limits, duplicate keys and messages in the words of the project.
#pragma once

#include <string>

#include "json/value.h"

namespace wrinkle::json {

struct Parsed {
    Value root;  // null if nothing could be parsed
    bool complete = false;
};

// `file` is the file name in locations, `max_depth` the maximum nesting of arrays and objects.
Parsed parse(std::string text, std::string file, Diagnostics& diagnostics, uint32_t max_depth = 64);

}  // namespace wrinkle::json

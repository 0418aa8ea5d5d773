// Serialises a Value to canonical text: numbers in their original spelling, strings with only the
// escapes that JSON requires, order preserved. Recursive: parse() limits the depth of values.
#pragma once

#include <string>

#include "base/text.h"
#include "json/value.h"

namespace wrinkle::json {

// Writes on one line: {"a": 1} becomes `{ "a": 1 }`, arrays `[1, 2]`, empty ones `{}` and `[]`.
std::string one_line(const Value& value);

// Writes arrays and objects that do not fit `width` columns with one child per line, indented by
// two more spaces. The first line is not indented and starts at column `column`; the following ones
// start with `indent` spaces.
std::string pretty(const Value& value, size_t indent = 0, size_t column = 0, size_t width = 100);

// Returns ["a", "b"]; [] if there are no words.
template <class Words>
std::string string_array(const Words& words) {
    return "[" + joined(words, ", ", json_quoted) + "]";
}

}  // namespace wrinkle::json

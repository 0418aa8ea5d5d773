// Value to canonical text: numbers as they were spelled, strings with only the escapes that JSON
// demands, order kept.
#pragma once

#include <string>
#include <vector>

#include "json/value.h"

namespace wrinkle::json {

// On one line: {"a": 1} is written `{ "a": 1 }`, arrays `[1, 2]`, empty ones `{}` and `[]`.
std::string one_line(const Value& value);

// An array or object that does not fit `width` columns is opened, one child a line, two spaces
// deeper. The first line is not indented; `indent` is what the following ones begin with, and
// `column` where the first one starts.
std::string pretty(const Value& value, size_t indent = 0, size_t column = 0, size_t width = 100);

// ["a", "b"], and [] of none.
std::string string_array(const std::vector<std::string>& words);

}  // namespace wrinkle::json

// Formatting of messages, numbers and durations for the user interface.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace wrinkle::editor {

// Returns `text` as a printable sentence: ends it with a full stop unless it ends with . ? or :,
// and capitalises it unless it begins with a user-defined name, recognised by a digit or one of
// . _ / : in the first word.
std::string sentence(std::string_view text);

// Returns the first error as "node: message", or "message" if it has no node; "" if there is none.
std::string first_error(const Diagnostics& problems);

std::string grouped(size_t number);                    // "1,024"
std::string counted(size_t number, const char* what);  // "1 node", "2,000 nodes"
std::string milliseconds(double time);                 // "0.7 ms", "1,115 ms"

std::string listed(const std::vector<std::string>& names);  // "a.json, b.json and c.json"
// As listed(); more than three files are counted: "4 files".
std::string listed_or_counted(const std::vector<std::string>& files);

}  // namespace wrinkle::editor

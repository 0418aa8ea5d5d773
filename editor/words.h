// Words for people.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/diagnostics.h"

namespace wrinkle::editor {

// With a capital letter and a full stop, unless it begins with a name of the user's: one with a
// digit, a dot, a slash or an underscore in it, or one that a colon follows.
std::string sentence(std::string_view text);

// The first error on one line, "node: message"; "" where there is none.
std::string first_error(const Diagnostics& problems);

std::string grouped(size_t number);                    // "1,024"
std::string counted(size_t number, const char* what);  // "1 node", "2,000 nodes"
std::string milliseconds(double time);                 // "0.7 ms", "1,115 ms"

}  // namespace wrinkle::editor

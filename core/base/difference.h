// Where two texts part.
#pragma once

#include <string>

namespace wrinkle {

// The first line that differs, in words; "" for equal texts.
std::string text_difference(const std::string& expected, const std::string& got);

}  // namespace wrinkle

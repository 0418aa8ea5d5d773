// Comparison of two texts by line.
#pragma once

#include <string>

namespace wrinkle {

// Describes the first line that differs; returns "" for equal texts.
std::string text_difference(const std::string& expected, const std::string& got);

}  // namespace wrinkle

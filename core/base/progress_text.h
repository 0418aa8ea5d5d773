// Formatting of counts and durations for progress messages.
#pragma once

#include <string>

namespace wrinkle {

std::string rough_count(double count);       // "5.2 M", "800 ": for use before a unit
std::string rough_duration(double seconds);  // "12 s", "3 min", "1 h 20 min"

}  // namespace wrinkle

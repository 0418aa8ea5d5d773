#include "base/progress_text.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <iterator>

namespace wrinkle {

std::string rough_count(double count) {
    const char* const units[] = {"", "k", "M", "G"};
    size_t unit = 0;
    while (count >= 1000 && unit + 1 < std::size(units)) {
        count /= 1000;
        ++unit;
    }
    char text[32];
    std::snprintf(text, sizeof text, "%.3g %s", count, units[unit]);
    return text;
}

std::string rough_duration(double seconds) {
    const auto whole = static_cast<uint64_t>(std::clamp(seconds + 0.5, 0.0, 1e9));
    if (whole < 100) return std::to_string(whole) + " s";
    const uint64_t minutes = (whole + 30) / 60;
    if (minutes < 100) return std::to_string(minutes) + " min";
    return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

}  // namespace wrinkle

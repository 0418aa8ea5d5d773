#include "base/difference.h"

#include <string_view>
#include <vector>

#include "base/text.h"

namespace wrinkle {
namespace {

std::string line_at(const std::vector<std::string_view>& lines, size_t i) {
    return i < lines.size() ? "'" + std::string(lines[i]) + "'" : "the end";
}

}  // namespace

std::string text_difference(const std::string& expected, const std::string& got) {
    if (expected == got) return "";
    const auto wanted = split(expected, '\n');
    const auto found = split(got, '\n');
    size_t i = 0;
    while (i < wanted.size() && i < found.size() && wanted[i] == found[i])
        ++i;
    return "line " + std::to_string(i + 1) + ": expected " + line_at(wanted, i) + ", got " +
           line_at(found, i);
}

}  // namespace wrinkle

#include "editor/model/words.h"

#include <cctype>
#include <cmath>
#include <cstdio>

#include "base/printable.h"

namespace wrinkle::editor {

std::string sentence(std::string_view text) {
    std::string result = printable(text);  // may contain names of files and nodes
    if (result.empty()) return result;
    const std::string_view word = text.substr(0, text.find(' '));
    const bool name = word.find_first_of("0123456789._/:") != word.npos;
    if (!name) result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
    const char last = result.back();
    if (last != '.' && last != '?' && last != ':') result += '.';
    return result;
}

std::string first_error(const Diagnostics& problems) {
    for (const Diagnostic& problem : problems.list())
        if (problem.severity == Severity::error)
            return (problem.node.empty() ? "" : problem.node + ": ") + problem.message;
    return {};
}

std::string grouped(size_t number) {
    std::string digits = std::to_string(number);
    for (size_t i = digits.size(); i > 3; i -= 3)
        digits.insert(i - 3, ",");
    return digits;
}

std::string counted(size_t number, const char* what) {
    return grouped(number) + " " + what + (number == 1 ? "" : "s");
}

std::string milliseconds(double time) {
    if (time >= 100) return grouped(static_cast<size_t>(std::lround(time))) + " ms";
    char text[32];
    std::snprintf(text, sizeof text, "%.1f ms", time);
    return text;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
    return text;
}

std::string listed_or_counted(const std::vector<std::string>& files) {
    return files.size() < 4 ? listed(files) : counted(files.size(), "file");
}

}  // namespace wrinkle::editor

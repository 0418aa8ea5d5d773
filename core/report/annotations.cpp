#include "report/annotations.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/printable.h"
#include "report/repository.h"

namespace wrinkle::report {
namespace {

// '%' first begins an escape, so it is escaped as well.
std::string command_escaped(std::string_view text, std::string_view special) {
    std::string result;
    for (const char c : text) {
        if (special.find(c) == special.npos)
            result += c;
        else if (c == '%')
            result += "%25";
        else if (c == '\r')
            result += "%0D";
        else if (c == '\n')
            result += "%0A";
        else
            result += c == ':' ? "%3A" : "%2C";
    }
    return result;
}

std::string command_property(std::string_view name, std::string_view value) {
    return std::string(name) + "=" + command_escaped(value, "%\r\n:,");
}

// Control characters are escaped as for a terminal: the log shows the line too.
std::string printable_lines(std::string_view text) {
    std::string result;
    while (true) {
        const size_t end = text.find_first_of("\r\n");
        result += printable(text.substr(0, end));
        if (end == text.npos) return result;
        result += text[end];
        text.remove_prefix(end + 1);
    }
}

std::string command_text(const Annotation& annotation) {
    std::vector<std::string> properties;
    if (!annotation.file.empty()) {
        properties.push_back(command_property("file", annotation.file));
        if (annotation.line > 0)
            properties.push_back(command_property("line", std::to_string(annotation.line)));
        if (annotation.line > 0 && annotation.column > 0)
            properties.push_back(command_property("col", std::to_string(annotation.column)));
    }
    if (!annotation.title.empty())
        properties.push_back(command_property("title", printable(annotation.title)));
    static constexpr std::array levels = {"::error", "::warning", "::notice"};
    std::string line = levels[static_cast<size_t>(annotation.level)];
    for (size_t i = 0; i < properties.size(); ++i)
        line += (i == 0 ? " " : ",") + properties[i];
    return line + "::" + command_escaped(printable_lines(annotation.text), "%\r\n") + "\n";
}

}  // namespace

std::string github_commands(std::vector<Annotation> annotations, const std::string& rest) {
    std::ranges::stable_sort(annotations, {}, &Annotation::level);
    if (annotations.size() > max_annotations) {
        const std::string more = std::to_string(annotations.size() - (max_annotations - 1));
        annotations.resize(max_annotations);
        Annotation& last = annotations.back();
        last = {last.level, "", 0, 0, "wrinkle", "and " + more + " more " + rest};
    }
    std::string lines;
    for (const Annotation& each : annotations)
        lines += command_text(each);
    return lines;
}

std::string github_annotations(const Diagnostics& diagnostics, const std::filesystem::path& root) {
    std::vector<Annotation> annotations;
    for (const Diagnostic& each : diagnostics.list()) {
        const Location& where = each.where;
        annotations.push_back({each.severity == Severity::error ? Annotation::Level::error
                                                                : Annotation::Level::warning,
                               where.file.empty() ? "" : path_in_repository(where.file, root),
                               where.line, where.column, std::string(info(each.rule).id),
                               sentence_of(each)});
    }
    std::string lines = github_commands(std::move(annotations), "problems; the log has them");
    if (diagnostics.dropped() > 0) lines += dropped_text(diagnostics) + "\n";
    return lines;
}

}  // namespace wrinkle::report

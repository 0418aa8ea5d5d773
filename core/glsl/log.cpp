#include "glsl/log.h"

#include <cctype>
#include <charconv>

namespace wrinkle {
namespace {

std::string_view first_line(std::string_view log) {
    while (!log.empty() && std::isspace(static_cast<unsigned char>(log.front())))
        log.remove_prefix(1);
    return log.substr(0, log.find('\n'));
}

}  // namespace

size_t line_in(std::string_view log) {
    for (size_t at = 0; at + 2 < log.size(); ++at) {
        if (log[at] != '0' || (log[at + 1] != ':' && log[at + 1] != '(')) continue;
        if (at > 0 && std::isalnum(static_cast<unsigned char>(log[at - 1]))) continue;
        size_t line = 0;
        const char* begin = log.data() + at + 2;
        const auto [end, problem] = std::from_chars(begin, log.data() + log.size(), line);
        if (problem == std::errc{} && end != begin) return line;
    }
    return 0;
}

uint32_t node_of_line(const Reflection& reflection, size_t line) {
    return line > 0 && line <= reflection.lines.size() ? reflection.lines[line - 1] : no_node;
}

Problem problem_of_log(const std::string& sentence, std::string_view log,
                       const Reflection& reflection) {
    const uint32_t node = node_of_line(reflection, line_in(log));
    return {node == no_node ? 0 : node, sentence + ": " + std::string(first_line(log)),
            "this is a fault of Wrinkle: please report it with the graph"};
}

}  // namespace wrinkle

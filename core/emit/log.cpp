#include "emit/log.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "base/text.h"

namespace wrinkle {
namespace {

std::string_view first_line(std::string_view log) {
    while (!log.empty() && std::isspace(static_cast<unsigned char>(log.front())))
        log.remove_prefix(1);
    return log.substr(0, log.find('\n'));
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// Returns true for the word before a line number: a source string's number, a file, or Metal's name
// for the source.
bool is_source(std::string_view word) {
    if (word.size() == 1) return is_digit(word[0]);
    const size_t dot = word.rfind('.');
    const bool file = dot != word.npos && dot + 1 < word.size() && !is_digit(word[dot + 1]);
    return file || word == "program_source";
}

// Returns the word that ends before `end`.
std::string_view word_before(std::string_view text, size_t end) {
    size_t begin = end;
    while (begin > 0 && text[begin - 1] > ' ' && text[begin - 1] != ':' && text[begin - 1] != '(')
        --begin;
    return text.substr(begin, end - begin);
}

// Returns the end of a location, given the end `at` of its line number: after the column, the
// closing parenthesis, colons and spaces.
size_t place_end(std::string_view text, size_t at, bool parenthesis) {
    if (parenthesis || text[at] == '(')
        at = std::min(text.find(')', at), text.size() - 1) + 1;
    else if (at + 1 < text.size() && is_digit(text[at + 1]))
        for (++at; at < text.size() && is_digit(text[at]);)
            ++at;
    return std::min(text.find_first_not_of(" :", at), text.size());
}

bool take_word(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    text.remove_prefix(std::min(text.find_first_not_of(" :"), text.size()));
    return true;
}

}  // namespace

LogLine read_log_line(std::string_view text) {
    LogLine result;
    result.message = text;
    result.warning = text.starts_with("WARNING") || text.starts_with("warning");
    for (size_t at = 1; at + 1 < text.size(); ++at) {
        const bool parenthesis = text[at] == '(';
        if ((text[at] != ':' && !parenthesis) || !is_digit(text[at + 1])) continue;
        if (!is_source(word_before(text, at))) continue;
        size_t line = 0;
        const char* const last = text.data() + text.size();
        const auto [end, problem] = std::from_chars(text.data() + at + 1, last, line);
        const std::string_view closing = parenthesis ? "),-" : ":(";
        if (problem != std::errc{} || end == last || closing.find(*end) == closing.npos) continue;
        result.line = line;
        result.message.remove_prefix(
            place_end(text, static_cast<size_t>(end - text.data()), parenthesis));
        if (take_word(result.message, "warning:")) result.warning = true;
        if (result.message.starts_with("warning")) result.warning = true;
        take_word(result.message, "error:");
        break;
    }
    return result;
}

size_t line_in(std::string_view log) {
    for (const std::string_view text : split(log, '\n'))
        if (const size_t line = read_log_line(text).line) return line;
    return 0;
}

uint32_t node_of_line(const Reflection& reflection, size_t line) {
    return line > 0 && line <= reflection.lines.size() ? reflection.lines[line - 1] : no_node;
}

Problem problem_of_log(const std::string& sentence, std::string_view log,
                       const Reflection& reflection) {
    const uint32_t node = node_of_line(reflection, line_in(log));
    return {RuleId::shader_rejected, node == no_node ? 0 : node,
            sentence + ": " + std::string(first_line(log)),
            "this is a fault of Wrinkle: please report it with the graph"};
}

}  // namespace wrinkle

#include "base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iterator>

namespace wrinkle {
namespace {

template <class T>
std::string spelled(T value) {
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    return std::string(buffer, end);
}

size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<size_t> row(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t above = row[j];
            const size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({row[j - 1] + 1, above + 1, replaced});
            diagonal = above;
        }
    }
    return row[b.size()];
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c);
}

std::string line_at(const std::vector<std::string_view>& lines, size_t i) {
    return i < lines.size() ? "'" + std::string(lines[i]) + "'" : "the end";
}

}  // namespace

std::string shortest(double value) {
    return spelled(value);
}
std::string shortest(float value) {
    return spelled(value);
}

// Escapes non-printable characters too, so that JSON printed to a terminal cannot forge a line.
std::string json_quoted(std::string_view text) {
    if (std::ranges::all_of(text, is_json_plain)) return '"' + std::string(text) + '"';
    std::string quoted = "\"";
    while (!text.empty()) {
        const Character character = first_character(text);
        const uint32_t code = character.code;
        if (code == '"' || code == '\\') {
            quoted += '\\';
            quoted += text[0];
        } else if (code == '\n') {
            quoted += "\\n";
        } else if (code == '\t') {
            quoted += "\\t";
        } else if (code == '\r') {
            quoted += "\\r";
        } else if (is_printable(character)) {
            quoted += text.substr(0, character.bytes);
        } else {
            constexpr uint32_t replacement = 0xFFFD;  // JSON is UTF-8
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", character.valid ? code : replacement);
            quoted += escape;
        }
        text.remove_prefix(character.bytes);
    }
    return quoted + "\"";
}

std::string lower_case(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

std::string identifier(std::string_view text) {
    std::string name;
    for (const char c : text)
        if (is_word(c))
            name += c;
        else if (!name.ends_with('_'))
            name += '_';
    if (name.empty() || is_digit(name[0])) name.insert(0, "n");
    return name;
}

bool is_identifier(std::string_view text) {
    return identifier(text) == text;
}

std::string nearest(std::string_view word, std::span<const std::string> candidates) {
    constexpr size_t max_word = 64;  // a longer word is not a typing error
    if (word.size() > max_word) return {};
    size_t best = std::max<size_t>(word.size() / 3, 1) + 1;
    std::string found;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > max_word) continue;
        const size_t distance = edit_distance(word, candidate);
        if (distance < best) {
            best = distance;
            found = candidate;
        }
    }
    return found;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates,
                         std::string otherwise) {
    const std::string near = nearest(word, candidates);
    return near.empty() ? std::move(otherwise) : "did you mean '" + near + "'?";
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    size_t begin = 0;
    for (size_t end = text.find(separator); end != text.npos; end = text.find(separator, begin)) {
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    parts.push_back(text.substr(begin));
    return parts;
}

bool is_utf8(std::string_view text) {
    if (std::ranges::all_of(text, is_printable_ascii)) return true;
    while (!text.empty()) {
        const Character character = first_character(text);
        if (!character.valid) return false;
        text.remove_prefix(character.bytes);
    }
    return true;
}

std::string_view trimmed(std::string_view text) {
    const size_t begin = std::min(text.find_first_not_of(" \t\r"), text.size());
    const size_t end = text.find_last_not_of(" \t\r");
    return text.substr(begin, end == text.npos ? 0 : end + 1 - begin);
}

std::optional<uint64_t> whole_number(std::string_view text) {
    uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return {};
    return number;
}

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

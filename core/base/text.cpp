#include "base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "base/printable.h"

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

// Character class of a byte in an identifier.
enum class Part : uint8_t { none, word, joint };

Part part_of(char c) {
    static constexpr auto table = [] {
        std::array<Part, 256> parts{};
        for (unsigned char byte = 0; byte < 26; ++byte)
            parts['a' + byte] = parts['A' + byte] = Part::word;
        for (unsigned char byte = '0'; byte <= '9'; ++byte)
            parts[byte] = Part::word;
        parts['_'] = Part::joint;
        return parts;
    }();
    return table[static_cast<unsigned char>(c)];
}

}  // namespace

std::string shortest(double value) {
    return spelled(value);
}
std::string shortest(float value) {
    return spelled(value);
}

// Small integers, the most common constants, skip the search for the fewest digits.
void append_shortest(std::string& text, float value) {
    constexpr float no_shorter_exponent = 10000;
    char buffer[64];
    const auto whole = static_cast<int>(std::clamp(value, 0.0F, no_shorter_exponent));
    const bool small =
        static_cast<float>(whole) == value && whole < no_shorter_exponent && !std::signbit(value);
    const auto end = small ? std::to_chars(buffer, buffer + sizeof buffer, whole).ptr
                           : std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    text.append(buffer, end);
}

// Escapes non-printable characters too, so that JSON printed to a terminal cannot forge a line.
std::string json_quoted(std::string_view text) {
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

std::string identifier(std::string_view text) {
    std::string name(text.size(), '_');
    size_t end = 0;
    for (const char c : text)
        if (part_of(c) == Part::word)
            name[end++] = c;
        else if (end == 0 || name[end - 1] != '_')
            name[end++] = '_';
    name.resize(end);
    if (name.empty() || is_digit(name[0])) name.insert(0, "n");
    return name;
}

bool is_identifier(std::string_view text) {
    if (text.empty() || is_digit(text[0])) return false;
    Part before = Part::word;
    for (const char c : text) {
        const Part part = part_of(c);
        if (part == Part::none || (part == Part::joint && before == Part::joint)) return false;
        before = part;
    }
    return true;
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
    while (!text.empty()) {
        const Character character = first_character(text);
        if (!character.valid) return false;
        text.remove_prefix(character.bytes);
    }
    return true;
}

}  // namespace wrinkle

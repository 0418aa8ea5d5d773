// Text helpers: locale-independent numbers, identifiers, suggestions, parts and lines.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/printable.h"

namespace wrinkle {

// Returns the shortest spelling that parses back to the same value ("0.1", "1e-07", "-0").
std::string shortest(double value);
std::string shortest(float value);

// Returns true for printable ASCII that a JSON string contains unescaped.
inline bool is_json_plain(char c) {
    return is_printable_ascii(c) && c != '"' && c != '\\';
}

// Returns a quoted JSON string. Printable characters (is_printable()) are copied unchanged, others
// are escaped; a byte that is not UTF-8 becomes U+FFFD.
std::string json_quoted(std::string_view text);

std::string lower_case(std::string text);  // changes A to Z

// Returns a C-like identifier: every byte outside [A-Za-z0-9_] becomes '_', runs of '_' become one
// (GLSL reserves "__"), and a leading digit is prefixed with "n"; never empty.
std::string identifier(std::string_view text);
bool is_identifier(std::string_view text);  // true if identifier() returns `text` unchanged

// Returns the candidate nearest to `word` if it is close enough to be a typing error, else "".
std::string nearest(std::string_view word, std::span<const std::string> candidates);

// Returns "did you mean 'weave'?" with the nearest candidate; `otherwise` if there is none.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates,
                         std::string otherwise = {});

// Returns the enumerator with this name; std::nullopt for an unknown name. `names` is in the order
// of the enumerators, which count from `first`.
template <class Enum>
std::optional<Enum> enumerator_named(std::span<const std::string_view> names, std::string_view name,
                                     int first = 0) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return {};
    return static_cast<Enum>(found - names.begin() + first);
}

std::vector<std::string_view> split(std::string_view text, char separator);

// Joins the texts of the elements of a list.
template <class List, class Text = std::identity>
std::string joined(const List& list, std::string_view separator, Text text_of = {}) {
    std::string text;
    bool is_first = true;
    for (const auto& each : list) {
        if (!is_first) text += separator;
        is_first = false;
        text += text_of(each);
    }
    return text;
}

// Returns `text` without spaces, tabs and carriage returns at its ends.
std::string_view trimmed(std::string_view text);

// Parses all of `text` as a decimal number; std::nullopt for anything else or beyond 64 bits.
std::optional<uint64_t> whole_number(std::string_view text);

std::string rough_count(double count);       // "5.2 M", "800 ": for use before a unit
std::string rough_duration(double seconds);  // "12 s", "3 min", "1 h 20 min"

// Describes the first line that differs; returns "" for equal texts.
std::string text_difference(const std::string& expected, const std::string& got);

// Returns true if the bytes are well-formed UTF-8 (no surrogates, no overlong forms).
bool is_utf8(std::string_view text);

}  // namespace wrinkle

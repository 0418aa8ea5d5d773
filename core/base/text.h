// Text helpers that several folders need: numbers without a locale, names, suggestions.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle {

// The shortest spelling that reads back as the same value ("0.1", "1e-07", "-0").
std::string shortest(double value);
std::string shortest(float value);
void append_shortest(std::string& text, float value);

// A quoted JSON string. What is_printable() passes unchanged; a byte that is not UTF-8: U+FFFD.
std::string json_quoted(std::string_view text);

// A C-like identifier: every byte outside [A-Za-z0-9_] becomes '_', runs of '_' become one (GLSL
// reserves "__"), a leading digit gets an "n" before it; never empty.
std::string identifier(std::string_view text);
bool is_identifier(std::string_view text);  // identifier() would change nothing

// The candidate nearest to `word` when it is near enough to be a slip of the hand, else "".
std::string nearest(std::string_view word, std::span<const std::string> candidates);

// "did you mean 'weave'?" of the nearest candidate, `otherwise` when there is none.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates,
                         std::string otherwise = {});

std::vector<std::string_view> split(std::string_view text, char separator);

// True when the bytes are well-formed UTF-8 (no surrogates, no overlong forms).
bool is_utf8(std::string_view text);

}  // namespace wrinkle

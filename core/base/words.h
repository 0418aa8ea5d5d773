// Text helpers: parsing of unsigned integers, trimming.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace wrinkle {

// Parses all of `text` as a decimal number; std::nullopt for anything else or beyond 64 bits.
inline std::optional<uint64_t> whole_number(std::string_view text) {
    uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return {};
    return number;
}

// Returns `text` without spaces, tabs and carriage returns at its ends.
inline std::string_view trimmed(std::string_view text) {
    const size_t begin = std::min(text.find_first_not_of(" \t\r"), text.size());
    const size_t end = text.find_last_not_of(" \t\r");
    return text.substr(begin, end == text.npos ? 0 : end + 1 - begin);
}

}  // namespace wrinkle

// Words of a command line: expands them before the parser reads them, and parses numbers in them.
//
// @FILE is replaced by the words of a file: separated by white space; '...' and "..." quote; a
// backslash escapes the next character, except inside '...'. Such files may nest 16 deep, 1000
// files and 16 MB in total; cycles are refused. `--at @FILE` is a file of points, and words after
// `--` are not expanded. A word that begins with @ or - and names an existing file is refused,
// because a shell pattern such as * may have produced it: ./@FILE names the file, @./FILE takes
// its words.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/text.h"
#include "image/image.h"

namespace wrinkle::cli {

// Returns the words without the program's name; std::nullopt and the reason in `why` if a file
// cannot be read, ends inside quotes, includes itself or exceeds a limit, or if a word is refused.
std::optional<std::vector<std::string>> command_words(int argc, const char* const* argv,
                                                      std::string& why);

// Returns `inputs` and the files that the last call of command_words() read.
std::vector<std::string> inputs_of_run(std::vector<std::string> inputs);

// As overwrite_fault(), of inputs_of_run().
std::string overwrite_fault_of_run(std::span<const std::string> outputs,
                                   std::vector<std::string> inputs);

// Returns the word as a POSIX shell reads it: in single quotes, unless all characters are plain.
std::string shell_quoted(const std::string& word);

// Names of all pixel types, in their order.
inline constexpr std::array pixel_type_names = {"u8", "u16", "half", "float"};
inline std::optional<PixelType> pixel_type_named(std::string_view name) {
    const auto found = std::ranges::find(pixel_type_names, name);
    if (found == pixel_type_names.end()) return {};
    return static_cast<PixelType>(found - pixel_type_names.begin());
}

// Parses all of `text` as a number; returns false for anything else.
template <class T>
bool parse_number(std::string_view text, T& number) {
    const char* end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, number);
    return problem == std::errc() && stop == end;
}

// Parses as many separated numbers as `numbers` holds, such as "0.5,0.25".
template <class T>
bool parse_numbers(std::string_view text, char separator, std::span<T> numbers) {
    const auto parts = split(text, separator);
    if (parts.size() != numbers.size()) return false;
    for (size_t i = 0; i < parts.size(); ++i)
        if (!parse_number(parts[i], numbers[i])) return false;
    return true;
}

// Parses "640x480", or "512" for 512 x 512. Returns false unless both sides are 1 to `max_side`.
template <class T>
bool parse_size(std::string_view text, std::type_identity_t<T> max_side, T& width, T& height) {
    const auto parts = split(text, 'x');
    const auto fits = [&](T side) { return side >= 1 && side <= max_side; };
    return parts.size() <= 2 && parse_number(parts.front(), width) &&
           parse_number(parts.back(), height) && fits(width) && fits(height);
}

}  // namespace wrinkle::cli

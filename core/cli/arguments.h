// Expands the words of a command line before the parser reads them.
//
// @FILE is replaced by the words of a file: separated by white space; '...' and "..." quote; a
// backslash escapes the next character, except inside '...'. Such files may nest 16 deep, 1000
// files and 16 MB in total; cycles are refused. `--at @FILE` is a file of points, and words after
// `--` are not expanded. A word that begins with @ or - and names an existing file is refused,
// because a shell pattern such as * may have produced it: ./@FILE names the file, @./FILE takes
// its words.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::cli {

// Returns the words without the program's name; std::nullopt and the reason in `why` if a file
// cannot be read, ends inside quotes, includes itself or exceeds a limit, or if a word is refused.
std::optional<std::vector<std::string>> command_words(int argc, const char* const* argv,
                                                      std::string& why);

// Files that the last call of command_words() read: inputs of the run, like any other.
const std::vector<std::string>& option_files();

}  // namespace wrinkle::cli

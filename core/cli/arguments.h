// The words of a command line before the parser sees them.
//
// @FILE stands for the words that a file holds: separated by white space, with '...' and "..."
// round what holds some, and a backslash before a character (not between '...') that stands for
// itself. Such a file may name others, 16 deep, 1000 in all, of 16 MB together; none that is being
// read. `--at @FILE` is a file of points, and after `--` every word is itself.
//
// A word that begins with @ or - and is the name of a file in the working folder is refused: a
// pattern such as * found it, and a file's name is not an option. ./@FILE names the file, and
// @./FILE takes its words.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::cli {

// Without the program's name. Nothing, with the reason in `why`, when a file cannot be read, ends
// inside quotes, names itself, or exceeds a limit, and when a word is refused.
std::optional<std::vector<std::string>> command_words(int argc, const char* const* argv,
                                                      std::string& why);

// The files that it took words from: inputs of the run, as any other.
const std::vector<std::string>& option_files();

}  // namespace wrinkle::cli

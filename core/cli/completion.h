// Shell completion. `wrinkle completion SHELL` prints a script that calls
// `wrinkle complete -- WORD...`; the candidates are made from the declared commands, the existing
// files and the nodes of the plugins that would be found.
#pragma once

#include <CLI/App.hpp>
#include <span>
#include <string>
#include <vector>

namespace wrinkle::cli {

// Returns candidates for the last of `words`, which is being typed and may be "". `words` excludes
// the program's name. Folders end with '/'. If the result is empty, the shell offers file names.
std::vector<std::string> completions(const CLI::App& app, std::span<const std::string> words);

// The script for "bash", "zsh" or "fish".
std::string completion_script(std::string_view shell);

}  // namespace wrinkle::cli

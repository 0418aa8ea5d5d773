// What a shell offers at the cursor: `wrinkle completion SHELL` prints a script that asks
// `wrinkle complete -- WORD...`, so what is offered is made from the commands as they are declared,
// from the files there are, and from the nodes of the plugins that would be found.
#pragma once

#include <CLI/App.hpp>
#include <span>
#include <string>
#include <vector>

namespace wrinkle::cli {

// `words` are those after the program's name; the last one, maybe "", is being typed. Folders end
// with '/'. Nothing: the shell's own file names are as good as anything.
std::vector<std::string> completions(const CLI::App& app, std::span<const std::string> words);

// The script for "bash", "zsh" or "fish".
std::string completion_script(std::string_view shell);

}  // namespace wrinkle::cli

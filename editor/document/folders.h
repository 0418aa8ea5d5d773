// Where the editor keeps what belongs to no graph: $XDG_CONFIG_HOME/wrinkle (settings) and
// $XDG_STATE_HOME/wrinkle (recovery files), by the XDG Base Directory Specification.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace wrinkle::editor {

struct Folders {
    std::filesystem::path config, state;  // both empty: nothing is kept
};

// From the environment; nothing is kept where it names no home.
Folders user_folders();
// Below one folder, for scripts and tests.
Folders folders_below(const std::filesystem::path& folder);

// "~" and "~/x" lead to the home folder; other paths stay.
std::filesystem::path with_home(const std::filesystem::path& typed);

// Why a file could not be written, as the end of a sentence: "the disk is full".
std::string disk_words(const std::error_code& error);
// The same where the core says it in a text that ends with the system's words.
std::string disk_words(std::string_view why);

}  // namespace wrinkle::editor

// Folders given by the environment and by the running program.
#pragma once

#include <filesystem>

namespace wrinkle {

// Returns Wrinkle's folder of one kind by the XDG Base Directory Specification:
// user_folder("XDG_DATA_HOME", ".local/share") is $XDG_DATA_HOME/wrinkle or
// $HOME/.local/share/wrinkle. Empty if neither variable holds an absolute path.
std::filesystem::path user_folder(const char* variable, const char* below_home);

// Returns the folder of the running program's file, symbolic links followed; empty if it is
// unknown.
std::filesystem::path program_folder();

// Returns the parent of the bin or lib folder that contains this code: the folder of the running
// program or, if the code is in a shared library, of that library. Installed data is below it.
// Symbolic links are followed; empty if it is unknown.
std::filesystem::path installation_folder();

}  // namespace wrinkle

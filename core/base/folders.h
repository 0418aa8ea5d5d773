// Folders that the environment and the running program name.
#pragma once

#include <filesystem>

namespace wrinkle {

// Wrinkle's folder of one kind by the XDG Base Directory Specification:
// user_folder("XDG_DATA_HOME", ".local/share") is $XDG_DATA_HOME/wrinkle or
// $HOME/.local/share/wrinkle. Empty where neither variable holds an absolute path.
std::filesystem::path user_folder(const char* variable, const char* below_home);

// Where the running program's file lies, symbolic links followed; empty when that is not known.
std::filesystem::path program_folder();

// The folder above the bin or lib that this code runs from: of the running program or, where it is
// in a shared library, of that library. What is installed with it lies below. Symbolic links
// followed; empty when it is not known.
std::filesystem::path installation_folder();

}  // namespace wrinkle

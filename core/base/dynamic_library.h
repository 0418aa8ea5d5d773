// Shared objects that a program loads on first use, so that their dependencies do not add to the
// start-up time.
//
// Search order: lib/wrinkle/FILE of the installation (base/folders.h), then each folder of the
// environment variable WRINKLE_MODULE_PATH (separated by ':'). The first file that exists is
// opened.
#pragma once

#include <string>

namespace wrinkle {

struct DynamicLibrary {
    void* library = nullptr;  // handle returned by dlopen; stays open
    void* symbol = nullptr;
    std::string path;
    std::string why;  // reason why `symbol` is null; one sentence
};

// Messages call the module `what`: "the image module".
DynamicLibrary open_library(const std::string& file, const char* symbol, const std::string& what);

inline constexpr const char* library_remedy =
    "install Wrinkle's lib/wrinkle beside its bin folder, or name the folder of the module in "
    "WRINKLE_MODULE_PATH";

// Returns "the image module FILE belongs to another version of Wrinkle"; closes the library.
std::string wrong_version(const DynamicLibrary& companion, const std::string& what);

}  // namespace wrinkle

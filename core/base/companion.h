// The modules that lie beside the programs: shared objects that a program opens on first need, so
// that a start does not pay for what they pull in.
//
// Looked for as lib/wrinkle/FILE of the installation (base/folders.h), then in each folder of the
// environment variable WRINKLE_MODULE_PATH (separated by ':'). The first that exists is taken.
#pragma once

#include <string>

namespace wrinkle {

struct Companion {
    void* library = nullptr;  // of dlopen; stays open
    void* symbol = nullptr;
    std::string path;
    std::string why;  // why there is no symbol; one sentence
};

// `what` names the module in sentences: "the image module".
Companion open_companion(const std::string& file, const char* symbol, const std::string& what);

inline constexpr const char* companion_remedy =
    "install Wrinkle's lib/wrinkle beside its bin folder, or name the folder of the module in "
    "WRINKLE_MODULE_PATH";

// "the image module FILE belongs to another version of Wrinkle"; closes the library.
std::string wrong_version(const Companion& companion, const std::string& what);

}  // namespace wrinkle

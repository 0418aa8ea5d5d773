#include "base/folders.h"

#include <dlfcn.h>
#include <link.h>

#include <cstdlib>

namespace wrinkle {
namespace fs = std::filesystem;

fs::path user_folder(const char* variable, const char* below_home) {
    const char* named = std::getenv(variable);
    if (named && fs::path(named).is_absolute()) return fs::path(named) / "wrinkle";
    const char* home = std::getenv("HOME");
    if (!home || !fs::path(home).is_absolute()) return {};
    return fs::path(home) / below_home / "wrinkle";
}

namespace {

// Returns the path of the shared library that contains this code; "" if it is the program itself.
fs::path own_library() {
    static const char inside = 0;
    Dl_info ignored;
    void* found = nullptr;
    if (!dladdr1(&inside, &ignored, &found, RTLD_DL_LINKMAP) || !found) return {};
    std::error_code error;
    const char* const name = static_cast<const link_map*>(found)->l_name;
    return name && *name ? fs::canonical(name, error) : fs::path();
}

}  // namespace

fs::path program_folder() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

// Evaluated once: the path of a library may be relative to the working folder, which can change.
fs::path installation_folder() {
    static const fs::path library = own_library();
    return (library.empty() ? program_folder() : library.parent_path()).parent_path();
}

}  // namespace wrinkle

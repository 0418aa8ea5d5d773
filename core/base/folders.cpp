#include "base/folders.h"

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

fs::path program_folder() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

}  // namespace wrinkle

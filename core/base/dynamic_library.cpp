#include "base/dynamic_library.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "base/folders.h"
#include "base/text.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> candidates(const std::string& file) {
    std::vector<fs::path> paths;
    const fs::path installation = installation_folder();
    if (!installation.empty()) paths.push_back(installation / "lib/wrinkle" / file);
    if (const char* folders = std::getenv("WRINKLE_MODULE_PATH"))
        for (const std::string_view folder : split(folders, ':'))
            if (!folder.empty()) paths.push_back(fs::path(folder) / file);
    return paths;
}

}  // namespace

DynamicLibrary open_library(const std::string& file, const char* symbol, const std::string& what) {
    DynamicLibrary found;
    std::string tried;
    for (const fs::path& path : candidates(file)) {
        std::error_code error;
        tried += (tried.empty() ? "" : ", ") + path.string();
        if (!fs::exists(path, error)) continue;
        found.path = path.string();
        found.library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
        const char* reason = found.library ? nullptr : dlerror();
        if (!found.library)
            found.why = what + " cannot be loaded: " + std::string(reason ? reason : path.c_str());
        else if (!(found.symbol = dlsym(found.library, symbol)))
            found.why = wrong_version(found, what);
        return found;
    }
    found.why = what + " is missing; looked for " + tried;
    return found;
}

std::string wrong_version(const DynamicLibrary& companion, const std::string& what) {
    if (companion.library) dlclose(companion.library);
    return what + " " + companion.path + " belongs to another version of Wrinkle";
}

}  // namespace wrinkle

#include "image/module.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "base/folders.h"
#include "base/text.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> candidates() {
    std::vector<fs::path> paths;
    const fs::path program = program_folder();
    if (!program.empty())
        paths.push_back(program.parent_path() / "lib/wrinkle" / WRINKLE_IMAGE_MODULE);
    if (const char* folders = std::getenv("WRINKLE_MODULE_PATH"))
        for (const std::string_view folder : split(folders, ':'))
            if (!folder.empty()) paths.push_back(fs::path(folder) / WRINKLE_IMAGE_MODULE);
    return paths;
}

const WrinkleImageModule* open_module(const fs::path& path, std::string& why) {
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) {
        const char* reason = dlerror();
        why = "the image module cannot be loaded: " + std::string(reason ? reason : path.c_str());
        return nullptr;
    }
    const auto entry =
        reinterpret_cast<WrinkleImageModuleEntry>(dlsym(library, WRINKLE_IMAGE_MODULE_SYMBOL));
    const WrinkleImageModule* module = entry ? entry() : nullptr;
    if (module && module->size >= sizeof(WrinkleImageModule) &&
        module->version == WRINKLE_IMAGE_MODULE_VERSION)
        return module;
    why = "the image module " + path.string() + " belongs to another version of Wrinkle";
    dlclose(library);
    return nullptr;
}

struct Found {
    const WrinkleImageModule* module = nullptr;
    std::string why;
};

Found find_module() {
    Found found;
    std::string tried;
    for (const fs::path& path : candidates()) {
        std::error_code error;
        if (fs::exists(path, error)) {
            found.module = open_module(path, found.why);
            return found;
        }
        tried += (tried.empty() ? "" : ", ") + path.string();
    }
    found.why = "the image module is missing; looked for " + tried;
    return found;
}

}  // namespace

const WrinkleImageModule* image_module(std::string& why) {
    static const Found found = find_module();
    why = found.why;
    return found.module;
}

}  // namespace wrinkle

#include "image/module.h"

namespace wrinkle {
namespace {

struct Found {
    const WrinkleImageModule* module = nullptr;
    std::string why;
};

Found find_module() {
    const std::string what = "the image module";
    const DynamicLibrary companion =
        open_library(WRINKLE_IMAGE_MODULE, WRINKLE_IMAGE_MODULE_SYMBOL, what);
    if (!companion.symbol) return {nullptr, companion.why};
    const auto entry = reinterpret_cast<WrinkleImageModuleEntry>(companion.symbol);
    const WrinkleImageModule* module = entry();
    if (module && module->size >= sizeof(WrinkleImageModule) &&
        module->version == WRINKLE_IMAGE_MODULE_VERSION)
        return {module, ""};
    return {nullptr, wrong_version(companion, what)};
}

}  // namespace

const WrinkleImageModule* image_module(std::string& why) {
    static const Found found = find_module();
    why = found.why;
    return found.module;
}

}  // namespace wrinkle

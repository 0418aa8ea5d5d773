#include "image/find_codec.h"

#include "image/png/png_codec.h"

namespace wrinkle {
namespace {

struct Found {
    const WrinkleImageCodec* codec = nullptr;
    std::string why;
};

Found load_module() {
    const std::string what = "the image module";
    const DynamicLibrary companion =
        open_library(WRINKLE_IMAGE_MODULE, WRINKLE_IMAGE_MODULE_SYMBOL, what);
    if (!companion.symbol) return {nullptr, companion.why};
    const auto entry = reinterpret_cast<WrinkleImageCodecEntry>(companion.symbol);
    const WrinkleImageCodec* codec = entry();
    if (codec && codec->size >= sizeof(WrinkleImageCodec) &&
        codec->version == WRINKLE_IMAGE_MODULE_VERSION)
        return {codec, ""};
    return {nullptr, wrong_version(companion, what)};
}

}  // namespace

const WrinkleImageCodec* find_codec(std::string_view format, std::string& why) {
    if (format == "png") return &png::table;
    static const Found module = load_module();
    why = module.why;
    return module.codec;
}

}  // namespace wrinkle

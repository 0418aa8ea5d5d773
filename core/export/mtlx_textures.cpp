#include "export/mtlx_textures.h"

#include <algorithm>

#include "base/file.h"
#include "base/srgb.h"
#include "export/files.h"
#include "image/load.h"

namespace wrinkle {
namespace fs = std::filesystem;

// Files of one name in several folders get numbers.
std::string MtlxTextures::free_file(const std::string& stem, const std::string& extension) {
    std::string file = "textures/" + stem + extension;
    for (int i = 2; !files_.insert(file).second; ++i)
        file = "textures/" + stem + "_" + std::to_string(i) + extension;
    return file;
}

std::string MtlxTextures::copy(const std::string& file) {
    std::string& copied = copies_[file];
    if (!copied.empty()) return copied;
    const fs::path path = file;
    copied = free_file(path.stem().string(), path.extension().string());
    std::string why;
    const auto bytes = read_file(path, limit_of(Limit::image_bytes), why);
    if (bytes)
        write_export_file(folder_ / copied, *bytes, diagnostics_);
    else
        diagnostics_.add(file_problem(Severity::error, RuleId::image_unreadable, file, why,
                                      "an image that can be read"));
    return copied;
}

std::string MtlxTextures::write(const Image& image, const std::string& stem, bool is_integer) {
    const std::string file = free_file(stem, is_integer ? ".png" : ".exr");
    WriterOptions options;
    options.type = is_integer ? PixelType::u16 : PixelType::float32;
    std::error_code error;
    fs::create_directories(folder_ / "textures", error);
    if (error)
        report_unwritable(folder_ / "textures", error, diagnostics_);
    else
        save_image(image, folder_ / file, options, diagnostics_);
    return file;
}

MtlxTextures::Map MtlxTextures::save(const BakedMaterial& material, const std::string& name,
                                     const BakedOutput& output, bool is_color) {
    const bool is_unit =
        std::ranges::all_of(output.texels, [](float value) { return value >= 0 && value <= 1; });
    const bool is_srgb = is_unit && is_color;
    const Image image = composed(material, output.channels, [&](size_t texel) {
        std::array<float, 4> values{};
        for (size_t i = 0; i < output.channels; ++i) {
            const float value = output.texels[texel * output.channels + i];
            values[i] = is_srgb ? static_cast<float>(srgb_from_linear(value)) : value;
        }
        return values;
    });
    return {write(image, name, is_unit), is_srgb};
}

MtlxTextures::Map MtlxTextures::save_normal(const BakedMaterial& material, const std::string& name,
                                            const BakedOutput& output) {
    const Image image = composed(material, 3, [&](size_t texel) {
        const auto at = [&](size_t i) { return 0.5F + 0.5F * output.texels[3 * texel + i]; };
        return std::array<float, 4>{at(0), at(1), at(2), 0};
    });
    return {write(image, name, true), false};
}

}  // namespace wrinkle

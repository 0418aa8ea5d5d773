#include "export/textures.h"

#include <algorithm>
#include <map>

#include "base/srgb.h"
#include "base/text.h"
#include "export/files.h"
#include "image/load.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

// Decodes the colors, not the alpha.
void decode_colors(Image& image) {
    const uint32_t colors = image.channels - (image.has_alpha ? 1 : 0);
    for (size_t i = 0; i < image.data.size(); ++i)
        if (i % image.channels < colors)
            image.data[i] = static_cast<float>(linear_from_srgb(image.data[i]));
}

class TextureCopies {
public:
    TextureCopies(const fs::path& folder, Diagnostics& diagnostics)
        : folder_(folder), diagnostics_(diagnostics) {}

    std::optional<ExportedTexture> copy(const SamplerInfo& sampler) {
        const bool srgb = sampler.options.decodes_texels();
        const auto [made, fresh] = copies_.try_emplace({sampler.file, srgb});
        if (fresh && !write(sampler.file, srgb, made->second)) return {};
        ExportedTexture texture = made->second;
        texture.sampler = sampler.name;
        texture.options = sampler.options;
        return texture;
    }

private:
    bool write(const std::string& from, bool srgb, ExportedTexture& copy) {
        auto image = load_image(from, diagnostics_);
        if (!image) return false;
        WriterOptions options;
        copy.is_float = image->source != PixelType::u8;
        if (copy.is_float) options.type = PixelType::float32;
        if (copy.is_float && srgb) decode_colors(*image);
        copy.srgb = srgb && !copy.is_float;
        copy.file = names_.take(from, copy.is_float ? ".exr" : ".png");
        std::error_code error;
        fs::create_directories(folder_ / "textures", error);
        if (error) return report_unwritable(folder_, error, diagnostics_), false;
        return save_image(*image, folder_ / copy.file, options, diagnostics_);
    }

    fs::path folder_;
    Diagnostics& diagnostics_;
    std::map<std::pair<std::string, bool>, ExportedTexture> copies_;  // by file and decoding
    TextureNames names_;
};

}  // namespace

std::string TextureNames::take(const std::string& from, std::string_view extension) {
    const std::string stem = identifier(fs::path(from).stem().string());
    std::string name = stem;
    for (int i = 2; !taken_.insert(lower_case(name)).second; ++i)
        name = stem + "_" + std::to_string(i);
    return "textures/" + name + std::string(extension);
}

std::vector<ExportedTexture> copy_textures(const Reflection& reflection, const fs::path& folder,
                                           Diagnostics& diagnostics) {
    TextureCopies copies(folder, diagnostics);
    std::vector<ExportedTexture> textures;
    for (const SamplerInfo& sampler : reflection.samplers) {
        auto texture = copies.copy(sampler);
        if (!texture) return {};
        textures.push_back(std::move(*texture));
    }
    return textures;
}

}  // namespace wrinkle

// Textures of Godot.
//
// A .stex file of Godot 3 is a header, then the texels of all levels, top row first (Godot 3.2,
// scene/resources/texture.cpp, StreamTexture).
#include <algorithm>
#include <map>

#include "base/srgb.h"
#include "export/files.h"
#include "export/godot.h"
#include "export/textures.h"
#include "image/load.h"
#include "image/mips.h"
#include "image/stored.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

// Texture flags and image formats of Godot 3.
enum StexFlag : uint32_t { stex_mipmaps = 1, stex_repeat = 2, stex_filter = 4, stex_mirror = 32 };
constexpr uint32_t stex_has_mipmaps = 1U << 23;
constexpr uint32_t format_rgb8 = 4, format_rgba8 = 5, format_rgbf = 10, format_rgbaf = 11;

void append_number(std::string& bytes, uint32_t number, int count) {
    for (int i = 0; i < count; ++i)
        bytes += static_cast<char>(number >> (8 * i) & 0xFF);
}

uint32_t stex_flags(const TextureOptions& options) {
    uint32_t flags = stex_mipmaps;
    if (options.filter == Filter::linear) flags |= stex_filter;
    if (options.wrap == Wrap::repeat) flags |= stex_repeat;
    if (options.wrap == Wrap::mirror) flags |= stex_mirror;
    return flags;
}

// Applies a function to the colors, not to alpha.
template <class Convert>
void convert_colors(Image& image, Convert convert) {
    for (size_t i = 0; i < image.data.size(); ++i)
        if (i % image.channels < 3) image.data[i] = static_cast<float>(convert(image.data[i]));
}

// Three channels, or four with alpha.
Image as_rgb(const Image& image) {
    Image expanded = to_rgba(image);
    if (image.has_alpha) return expanded;
    Image rgb = make_image(image.width, image.height, 3, image.source);
    for (size_t i = 0; i < rgb.data.size(); ++i)
        rgb.data[i] = expanded.data[i / 3 * 4 + i % 3];
    return rgb;
}

// Texels of a level from its top row.
void append_level(std::string& bytes, const Image& level, PixelType type) {
    const size_t row = size_t{level.width} * level.channels;
    std::vector<std::byte> stored(row * bytes_of(type));
    for (uint32_t y = level.height; y-- > 0;) {
        store_values(type, std::span(level.data).subspan(y * row, row), stored.data());
        bytes.append(reinterpret_cast<const char*>(stored.data()), stored.size());
    }
}

// `srgb`: values are coded; mips are means of light.
std::string stex_bytes(const Image& loaded, const TextureOptions& options) {
    const bool bytes_kept = loaded.source == PixelType::u8;
    const bool srgb = options.decodes_texels();
    Image image = as_rgb(loaded);
    if (srgb) convert_colors(image, [](double c) { return linear_from_srgb(c); });
    const bool alpha = image.channels == 4;
    const uint32_t format =
        bytes_kept ? (alpha ? format_rgba8 : format_rgb8) : (alpha ? format_rgbaf : format_rgbf);
    std::string bytes = "GDST";
    append_number(bytes, image.width, 4);  // 16 bits, and 16 of another size to show: none
    append_number(bytes, image.height, 4);
    append_number(bytes, stex_flags(options), 4);
    append_number(bytes, format | stex_has_mipmaps, 4);
    MipChain mips = build_mips(std::move(image));
    for (Image& level : mips.levels) {
        if (srgb && bytes_kept) convert_colors(level, [](double c) { return srgb_from_linear(c); });
        append_level(bytes, level, bytes_kept ? PixelType::u8 : PixelType::float32);
    }
    return bytes;
}

class StexFiles {
public:
    StexFiles(const fs::path& folder, Diagnostics& diagnostics)
        : folder_(folder), diagnostics_(diagnostics) {}

    // One file for samplers with equal options.
    std::optional<GodotTexture> write(const SamplerInfo& sampler) {
        const TextureOptions& options = sampler.options;
        const auto [made, fresh] = files_.try_emplace(
            {sampler.file, options.decodes_texels(), stex_flags(options)}, File{});
        if (fresh && !write(sampler, made->second)) return {};
        const bool decodes = options.decodes_texels() && !made->second.is_float;
        return GodotTexture{sampler.name, made->second.name, decodes ? "hint_albedo" : ""};
    }

private:
    struct File {
        std::string name;
        bool is_float = false;
    };

    bool write(const SamplerInfo& sampler, File& file) {
        const auto image = load_image(sampler.file, diagnostics_);
        if (!image) return false;
        file.is_float = image->source != PixelType::u8;
        file.name = names_.take(sampler.file, ".stex");
        return write_export_file(folder_ / file.name, stex_bytes(*image, sampler.options),
                                 diagnostics_);
    }

    const fs::path& folder_;
    Diagnostics& diagnostics_;
    std::map<std::tuple<std::string, bool, uint32_t>, File> files_;
    TextureNames names_;
};

// Settings of Godot 4's importer: no compression, mips, no change when used in 3D.
constexpr std::string_view import_settings = R"([remap]

importer="texture"
type="CompressedTexture2D"

[params]

compress/mode=0
compress/high_quality=false
compress/hdr_compression=0
compress/normal_map=2
compress/channel_pack=0
mipmaps/generate=true
mipmaps/limit=-1
roughness/mode=1
process/fix_alpha_border=false
process/premult_alpha=false
process/normal_map_invert_y=false
process/hdr_as_srgb=false
process/hdr_clamp_exposure=false
process/size_limit=0
detect_3d/compress_to=0
)";

std::string hints_of(const ExportedTexture& texture) {
    std::string hints = texture.srgb ? "source_color, " : "";
    hints += texture.options.filter == Filter::nearest ? "filter_nearest_mipmap"
                                                       : "filter_linear_mipmap";
    return hints + (texture.options.wrap == Wrap::clamp ? ", repeat_disable" : ", repeat_enable");
}

// Godot reads OpenEXR files with red, green and blue.
bool make_rgb(const fs::path& path, Diagnostics& diagnostics) {
    const auto image = load_image(path, diagnostics);
    if (!image) return false;
    if (image->channels >= 3) return true;
    WriterOptions options;
    options.type = PixelType::float32;
    return save_image(as_rgb(*image), path, options, diagnostics);
}

std::optional<std::vector<GodotTexture>> imported_textures(const ExportRequest& request,
                                                           const std::vector<SamplerInfo>& samplers,
                                                           const fs::path& folder,
                                                           Diagnostics& diagnostics) {
    Reflection reflection;
    reflection.samplers = samplers;
    const auto copies = copy_textures(reflection, folder, diagnostics);
    if (diagnostics.has_errors()) return {};
    std::vector<GodotTexture> textures;
    for (const ExportedTexture& copy : copies) {
        if (copy.is_float && !make_rgb(folder / copy.file, diagnostics)) return {};
        if (!write_export_file(folder / (copy.file + ".import"), import_settings, diagnostics))
            return {};
        if (copy.options.wrap == Wrap::mirror)
            diagnostics.add(file_problem(Severity::warning, RuleId::host_lacks, request.graph,
                                         "Godot 4 has no mirrored repetition of textures",
                                         copy.file + " is repeated"));
        textures.push_back({copy.sampler, copy.file, hints_of(copy)});
    }
    return textures;
}

}  // namespace

std::optional<std::vector<GodotTexture>> write_godot_textures(
    const ExportRequest& request, const GodotVersion& version,
    const std::vector<SamplerInfo>& samplers, const fs::path& folder, Diagnostics& diagnostics) {
    if (version.major > 3) return imported_textures(request, samplers, folder, diagnostics);
    StexFiles files(folder, diagnostics);
    std::vector<GodotTexture> textures;
    for (const SamplerInfo& sampler : samplers) {
        auto texture = files.write(sampler);
        if (!texture) return {};
        textures.push_back(std::move(*texture));
    }
    return textures;
}

}  // namespace wrinkle

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <span>
#include <string_view>

#include "base/file.h"
#include "image/half.h"
#include "image/load.h"
#include "image/module.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

// What a format can hold. Lists are words separated by blanks.
struct Writable {
    const char* extensions;
    const char* plugin;
    const char* types;
    const char* channels;
    const char* compressions;
    const char* compression;  // the default
};

constexpr std::array formats = {
    Writable{".png", "png", "u8 u16", "1 2 3 4", "", ""},
    Writable{".jpg .jpeg", "jpeg", "u8", "1 3", "", ""},
    Writable{".tif .tiff", "tiff", "u8 u16 half float", "1 2 3 4", "none lzw zip", "zip"},
    Writable{".exr", "openexr", "half float", "1 2 3 4", "none rle zip zips piz", "zip"},
    Writable{".hdr", "hdr", "float", "3", "", ""},
};

bool has_word(std::string_view words, std::string_view word) {
    const std::string padded = " " + std::string(words) + " ";
    return padded.find(" " + std::string(word) + " ") != padded.npos;
}

const Writable* format_of(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    for (const Writable& format : formats)
        if (!extension.empty() && has_word(format.extensions, extension)) return &format;
    return nullptr;
}

struct Problem {
    std::string message;  // "" when there is none
    std::string expected;
};

Problem find_problem(const Image& image, const Writable* format, const SaveOptions& options) {
    if (image.empty()) return {"has no pixels", "at least one pixel"};
    if (!format)
        return {"has an extension that is no image format to write",
                ".png, .jpg, .tif, .exr or .hdr"};
    if (!has_word(format->types, name_of(options.type)))
        return {"cannot hold values of type " + std::string(name_of(options.type)),
                "one of: " + std::string(format->types)};
    if (!has_word(format->channels, std::to_string(image.channels)))
        return {"cannot hold " + std::to_string(image.channels) + " channels",
                "one of: " + std::string(format->channels)};
    if (image.channels == 2 && !image.has_alpha && std::string_view(format->plugin) == "png")
        return {"cannot hold red and green alone", "three channels, or a .tif or .exr file"};
    if (!options.compression.empty() && !has_word(format->compressions, options.compression))
        return {"has no compression '" + options.compression + "'",
                *format->compressions ? "one of: " + std::string(format->compressions)
                                      : "no compression named: the format has one of its own"};
    if (options.quality < 1 || options.quality > 100)
        return {"cannot have quality " + std::to_string(options.quality), "1 to 100"};
    return {};
}

// Not clamp: NaN must land on 0.
double rounded(double value, double max) {
    if (!(value > 0)) return 0;
    return value < 1 ? std::floor(value * max + 0.5) : max;
}

template <typename Stored, typename Convert>
void store_row(std::span<const float> row, std::byte* out, Convert convert) {
    for (const float value : row) {
        const Stored stored = static_cast<Stored>(convert(value));
        std::memcpy(out, &stored, sizeof stored);
        out += sizeof stored;
    }
}

void row_from_float(PixelType type, std::span<const float> row, std::byte* out) {
    switch (type) {
        case PixelType::u8:
            return store_row<uint8_t>(row, out, [](float v) { return rounded(v, 255); });
        case PixelType::u16:
            return store_row<uint16_t>(row, out, [](float v) { return rounded(v, 65535); });
        case PixelType::half:
            return store_row<uint16_t>(row, out, half_from_float);
        case PixelType::float32:
            return store_row<float>(row, out, [](float v) { return v; });
    }
}

// Top row first, as files have it.
std::vector<std::byte> stored_pixels(const Image& image, PixelType type) {
    const size_t count = size_t{image.width} * image.channels;
    const size_t stride = count * bytes_of(type);
    std::vector<std::byte> stored(stride * image.height);
    for (uint32_t y = 0; y < image.height; ++y)
        row_from_float(type, {image.texel(0, y), count},
                       stored.data() + (image.height - 1 - y) * stride);
    return stored;
}

bool write_pixels(const WrinkleImageModule& module, const Image& image, const fs::path& path,
                  const Writable& format, const SaveOptions& options, std::string& why) {
    const std::vector<std::byte> pixels = stored_pixels(image, options.type);
    const std::string compression =
        options.compression.empty() ? format.compression : options.compression;
    WrinkleImageWrite what = {};
    what.format = format.plugin;
    what.compression = compression.c_str();
    what.quality = options.quality;
    what.header = {image.width, image.height, image.channels, image.has_alpha,
                   static_cast<uint32_t>(options.type)};
    what.pixels = pixels.data();
    char text[512] = "";
    if (module.write(path.c_str(), &what, {text, sizeof text})) return true;
    why = text;
    return false;
}

// Asked of the system first: its reason is better than OpenImageIO's.
bool can_create(const fs::path& path, std::string& why) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (!file) why = std::strerror(errno);
    return file && std::fclose(file) == 0;
}

bool write_whole(const WrinkleImageModule& module, const Image& image, const fs::path& path,
                 const Writable& format, const SaveOptions& options, std::string& why) {
    fs::path temporary = link_target(path);
    temporary.replace_filename("." + path.stem().string() + ".tmp" + std::to_string(getpid()) +
                               path.extension().string());
    if (can_create(temporary, why) &&
        write_pixels(module, image, temporary, format, options, why) &&
        replace_file(temporary, path, why))
        return true;
    std::error_code ignored;
    fs::remove(temporary, ignored);
    return false;
}

}  // namespace

bool save_image(const Image& image, const fs::path& path, const SaveOptions& options,
                Diagnostics& diagnostics) {
    const std::string name = "image '" + path.string() + "' ";
    const Writable* format = format_of(path);
    const Problem problem = find_problem(image, format, options);
    if (!problem.message.empty()) {
        diagnostics.error(name + problem.message, problem.expected);
        return false;
    }
    assert(image.data.size() == size_t{image.width} * image.height * image.channels);
    std::string why;
    const WrinkleImageModule* module = image_module(why);
    if (module && write_whole(*module, image, path, *format, options, why)) return true;
    diagnostics.error(name + "cannot be written: " + why,
                      module ? "a folder that can be written to" : companion_remedy);
    return false;
}

}  // namespace wrinkle

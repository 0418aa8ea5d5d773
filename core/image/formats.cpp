#include "image/formats.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "base/file.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view bytes;
    const char* name;
    const char* plugin;
};

constexpr std::array signatures = {
    Signature{"\x89PNG\r\n\x1A\n"sv, "png", "png"},
    Signature{"\xFF\xD8\xFF"sv, "jpeg", "jpeg"},
    Signature{"II*\0"sv, "tiff", "tiff"},
    Signature{"MM\0*"sv, "tiff", "tiff"},
    Signature{"II+\0"sv, "tiff", "tiff"},
    Signature{"MM\0+"sv, "tiff", "tiff"},
    Signature{"\x76\x2F\x31\x01"sv, "exr", "openexr"},
    Signature{"#?RADIANCE"sv, "hdr", "hdr"},
    Signature{"#?RGBE"sv, "hdr", "hdr"},
};

// "P1" to "P6", "PF" and "Pf", each followed by white space or a comment.
bool is_pnm(std::string_view head) {
    return head.size() > 2 && head[0] == 'P' && "123456Ff"sv.find(head[1]) != head.npos &&
           " \t\r\n#"sv.find(head[2]) != head.npos;
}

std::string read_head(const fs::path& path, std::string& why) {
    const OpenedFile file = open_to_read(path, why);
    if (!file) return {};
    char buffer[32];
    const size_t count = std::fread(buffer, 1, sizeof buffer, file.get());
    if (count == 0) why = std::ferror(file.get()) ? "cannot be read" : "is empty (0 bytes)";
    return std::string(buffer, count);
}

constexpr std::array writables = {
    Writable{".png", "png", "u8 u16", "1 2 3 4", "", "", false, false, true},
    Writable{".jpg .jpeg", "jpeg", "u8", "1 3", "", "", false, false, true},
    Writable{".tif .tiff", "tiff", "u8 u16 half float", "", "none lzw zip", "zip", true, false,
             true},
    Writable{".exr", "openexr", "half float", "", "none rle zip zips piz", "zip", true, true, true},
    Writable{".hdr", "hdr", "float", "3", "", "", false, false, false},
};

// Git LFS checks out a text with these first words if it did not fetch a file.
constexpr std::string_view lfs_pointer = "version https://git-lfs";

bool has_word(std::string_view words, std::string_view word) {
    const std::string padded = " " + std::string(words) + " ";
    return padded.find(" " + std::string(word) + " ") != padded.npos;
}

WriteProblem find_layout_problem(const Writable& format, const WriterOptions& options) {
    if (options.mips && !format.mips) return {"cannot hold mip levels", "an .exr file"};
    if (options.tile > 0 && !format.tiles) return {"cannot hold tiles", "a .tif or .exr file"};
    if (options.tile % 16 != 0)
        return {"cannot have tiles of side " + std::to_string(options.tile), "a multiple of 16"};
    if (options.mips && options.tile == 0)
        return {"cannot hold mip levels without tiles", "tiles of 64, say"};
    if (options.quality < 1 || options.quality > 100)
        return {"cannot have quality " + std::to_string(options.quality), "1 to 100"};
    return {};
}

}  // namespace

std::string quoted(const fs::path& path) {
    return "image '" + path.string() + "' ";
}

ImageFormat sniff_format(const fs::path& path, std::string& why) {
    const std::string head = read_head(path, why);
    if (head.empty()) return {};
    for (const Signature& signature : signatures)
        if (head.starts_with(signature.bytes)) return {signature.name, signature.plugin};
    if (is_pnm(head)) return {"pnm", "pnm"};
    why = head.starts_with(lfs_pointer) ? "is a pointer of Git LFS; `git lfs pull` gets the image"
                                        : "is not an image of a known format";
    return {};
}

int png_bits(const fs::path& path) {
    constexpr size_t bit_depth = 24;  // after the signature, length, "IHDR", width and height
    std::string unreadable;
    const std::string head = read_head(path, unreadable);
    const bool is_png = head.starts_with(signatures[0].bytes) && head.size() > bit_depth;
    return is_png ? head[bit_depth] : 0;
}

const Writable* format_to_write(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    for (const Writable& format : writables)
        if (!extension.empty() && has_word(format.extensions, extension)) return &format;
    return nullptr;
}

bool plugin_keeps_numbers(std::string_view plugin) {
    return std::ranges::any_of(writables, [&](const Writable& format) {
        return format.numbers && format.plugin == plugin;
    });
}

WriteProblem find_write_problem(const Writable* format, const WriterOptions& options) {
    const size_t channels = options.channels.size();
    if (options.width == 0 || options.height == 0 || channels == 0)
        return {"has no pixels", "at least one pixel"};
    if (!format)
        return {"does not end in the extension of an image format",
                ".png, .jpg, .tif, .exr or .hdr"};
    if (!has_word(format->types, name_of(options.type)))
        return {"cannot hold values of type " + std::string(name_of(options.type)),
                "one of: " + std::string(format->types)};
    if (*format->channels && !has_word(format->channels, std::to_string(channels)))
        return {"cannot hold " + std::to_string(channels) + " channels",
                "one of: " + std::string(format->channels)};
    if (channels == 2 && !options.has_alpha && std::string_view(format->plugin) == "png")
        return {"cannot hold red and green alone", "three channels, or a .tif or .exr file"};
    if (!options.compression.empty() && !has_word(format->compressions, options.compression))
        return {"has no compression '" + options.compression + "'",
                *format->compressions ? "one of: " + std::string(format->compressions)
                                      : "no compression named: the format has one of its own"};
    return find_layout_problem(*format, options);
}

}  // namespace wrinkle

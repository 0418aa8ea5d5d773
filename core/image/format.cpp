#include "image/format.h"

#include <array>
#include <cstdio>
#include <string_view>

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
    char buffer[16];
    const size_t count = std::fread(buffer, 1, sizeof buffer, file.get());
    if (count == 0) why = std::ferror(file.get()) ? "cannot be read" : "is empty (0 bytes)";
    return std::string(buffer, count);
}

}  // namespace

ImageFormat sniff_format(const fs::path& path, std::string& why) {
    const std::string head = read_head(path, why);
    if (head.empty()) return {};
    for (const Signature& signature : signatures)
        if (head.starts_with(signature.bytes)) return {signature.name, signature.plugin};
    if (is_pnm(head)) return {"pnm", "pnm"};
    why = "is not an image of a known format";
    return {};
}

}  // namespace wrinkle

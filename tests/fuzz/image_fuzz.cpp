// Fuzz target: the result is an image as its header describes, with finite values or a warning, or
// one error.
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "fuzz/fuzz.h"
#include "image/load.h"
#include "image/mips.h"

namespace wrinkle::fuzz {
namespace {

constexpr ImageLimits limits{512, 512 * 512, 8 << 20};

// Writes the bytes to an in-memory file, reused by every call; returns its path.
std::string file_of(std::string_view bytes) {
    static const int file = memfd_create("image", 0);
    const auto size = static_cast<ssize_t>(bytes.size());
    const bool written =
        ftruncate(file, 0) == 0 && pwrite(file, bytes.data(), bytes.size(), 0) == size;
    return written ? "/proc/self/fd/" + std::to_string(file) : "";
}

bool equal(const ImageInfo& info, const Image& image) {
    return info.width == image.width && info.height == image.height &&
           info.channels == image.channels && info.has_alpha == image.has_alpha &&
           info.source == image.source;
}

std::string wrong_with(const Image& image, const ImageInfo& info, bool warned) {
    if (!equal(info, image)) return "a picture other than its header";
    const size_t count = size_t{image.width} * image.height * image.channels;
    if (count == 0 || image.data.size() != count || image.channels > 4) return "a wrong size";
    if (count * sizeof(float) > limits.max_bytes) return "a picture over the limits";
    const bool finite = std::all_of(image.data.begin(), image.data.end(),
                                    [](float value) { return std::isfinite(value); });
    if (finite == warned) return "NaN or infinity without a warning, or the reverse";
    return build_mips(image).levels.empty() ? "no mips" : "";
}

}  // namespace

std::string image(std::string_view bytes) {
    const std::string path = file_of(bytes);
    if (path.empty()) return "no file for the bytes";
    Diagnostics of_header, diagnostics;
    const auto info = read_image_info(path, limits, of_header);
    const auto image = load_image(path, limits, diagnostics);
    if (diagnostics.error_count() != (image ? 0 : 1)) return "a picture and an error, or neither";
    for (const Diagnostic& diagnostic : diagnostics.list())
        if (diagnostic.message.find(path) == std::string::npos ||
            diagnostic.message.find('\n') != std::string::npos || diagnostic.expected.empty())
            return "an error of several lines, without the file or a remedy";
    if (!image) return "";
    return info ? wrong_with(*image, *info, !diagnostics.list().empty()) : "a header refused";
}

}  // namespace wrinkle::fuzz

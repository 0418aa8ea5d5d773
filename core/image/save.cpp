#include <algorithm>
#include <cassert>

#include "image/load.h"

namespace wrinkle {

namespace {

constexpr uint32_t band_rows = 64;

// Writes from the top: the file's first row is the top one, the image's first row the bottom one.
bool write_upside_down(ImageWriter& writer, const Image& image, Diagnostics& diagnostics) {
    const size_t count = size_t{image.width} * image.channels;
    std::vector<float> band;
    for (uint32_t top = image.height; top > 0;) {
        const uint32_t rows = std::min(top, band_rows);
        band.clear();
        for (uint32_t i = 0; i < rows; ++i) {
            const float* row = image.texel(0, --top);
            band.insert(band.end(), row, row + count);
        }
        if (!writer.write(band, diagnostics)) return false;
    }
    return true;
}

}  // namespace

bool save_image(const Image& image, const std::filesystem::path& path, WriterOptions options,
                Diagnostics& diagnostics) {
    assert(image.data.size() == size_t{image.width} * image.height * image.channels);
    options.width = image.width;
    options.height = image.height;
    options.channels = channel_names(image.channels, image.has_alpha);
    options.has_alpha = image.has_alpha;
    auto writer = ImageWriter::open(path, options, diagnostics);
    return writer && write_upside_down(*writer, image, diagnostics) && writer->finish(diagnostics);
}

}  // namespace wrinkle

#include "image/load.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <utility>

#include "image/format.h"
#include "image/module.h"
#include "image/stored.h"
#include "image/writable.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

struct CloseReader {
    const WrinkleImageModule* module;
    void operator()(WrinkleImageReader* reader) const { module->close(reader); }
};
using Reader = std::unique_ptr<WrinkleImageReader, CloseReader>;

std::string quoted(const fs::path& path) {
    return "image '" + path.string() + "' ";
}

struct Opened {
    ImageInfo info;
    Reader reader{nullptr, CloseReader{nullptr}};
};

void refuse_size(const fs::path& path, const std::string& what, uint64_t found, uint64_t limit,
                 const char* variable, Diagnostics& diagnostics) {
    diagnostics.error(quoted(path) + "has " + what + " " + std::to_string(found) +
                          ", over the limit of " + std::to_string(limit),
                      "a smaller image, or set " + std::string(variable) + "=" +
                          std::to_string(found) + " to raise the limit");
}

void refuse_together(const fs::path& path, uint64_t found, uint64_t left,
                     Diagnostics& diagnostics) {
    const uint64_t all = limit_of(Limit::all_images_bytes);
    diagnostics.error(quoted(path) + "has a size in memory of " + std::to_string(found) +
                          " with its mips, and of the limit of " + std::to_string(all) +
                          " for all images of the graph " + std::to_string(left) + " are left",
                      "fewer or smaller images, or set " +
                          std::string(row_of(Limit::all_images_bytes).variable) + "=" +
                          std::to_string(all - left + found) + " to raise the limit");
}

bool within_limits(const fs::path& path, const ImageInfo& info, const ImageLimits& limits,
                   Diagnostics& diagnostics) {
    if (info.width == 0 || info.height == 0) {
        diagnostics.error(quoted(path) + "has no pixels", "at least one pixel");
        return false;
    }
    const uint64_t pixels = uint64_t{info.width} * info.height;
    const uint64_t bytes = pixels * info.channels * sizeof(float);
    const char* side = "WRINKLE_IMAGE_MAX_SIDE";
    if (info.width > limits.max_side)
        refuse_size(path, "width", info.width, limits.max_side, side, diagnostics);
    else if (info.height > limits.max_side)
        refuse_size(path, "height", info.height, limits.max_side, side, diagnostics);
    else if (pixels > limits.max_pixels)
        refuse_size(path, "a pixel count of", pixels, limits.max_pixels, "WRINKLE_IMAGE_MAX_PIXELS",
                    diagnostics);
    else if (bytes > limits.max_bytes)
        refuse_size(path, "a size in memory of", bytes, limits.max_bytes, "WRINKLE_IMAGE_MAX_BYTES",
                    diagnostics);
    else if (bytes_with_mips(info) > limits.left_bytes)
        refuse_together(path, bytes_with_mips(info), limits.left_bytes, diagnostics);
    else
        return true;
    return false;
}

uint32_t side_of(const ImageLimits& limits) {
    return static_cast<uint32_t>(std::min<uint64_t>(limits.max_side, UINT32_MAX));
}

Opened open_within(const fs::path& path, const ImageLimits& limits, Diagnostics& diagnostics) {
    Opened opened;
    std::string why;
    const ImageFormat format = sniff_format(path, why);
    if (format.name.empty()) {
        diagnostics.error(quoted(path) + why, readable_formats);
        return opened;
    }
    const WrinkleImageModule* module = image_module(why);
    if (!module) {
        diagnostics.error(quoted(path) + "cannot be read: " + why, library_remedy);
        return opened;
    }
    char text[512] = "";
    WrinkleImageHeader header = {};
    WrinkleImageReader* reader = module->open(path.c_str(), format.plugin.c_str(), side_of(limits),
                                              &header, {text, sizeof text});
    opened.reader = Reader(reader, CloseReader{module});
    opened.info = {format.name,     header.width,          header.height,
                   header.channels, header.has_alpha != 0, static_cast<PixelType>(header.type)};
    if ((reader || header.width > 0) && !within_limits(path, opened.info, limits, diagnostics))
        opened.reader.reset();
    else if (!reader)
        diagnostics.error(quoted(path) + "cannot be read as " + format.name + ": " + text,
                          "a complete file with one to four channels; export it again");
    return opened;
}

struct NonFinite {
    size_t count = 0;
    size_t x = 0, y = 0;  // first one, from the bottom left
};

// Rows arrive from the top, so the last row with a non-finite value contains the first one.
void note_non_finite(const ImageInfo& info, uint32_t y, const float* row, NonFinite& found) {
    const auto is_bad = [](float value) { return !std::isfinite(value); };
    const float* end = row + size_t{info.width} * info.channels;
    const auto count = std::count_if(row, end, is_bad);
    if (count == 0) return;
    const auto first = static_cast<size_t>(std::find_if(row, end, is_bad) - row);
    found = {found.count + static_cast<size_t>(count), first / info.channels, y};
}

void warn_of_non_finite(const fs::path& path, const NonFinite& found, Diagnostics& diagnostics) {
    Diagnostic warning;
    warning.severity = Severity::warning;
    warning.message = quoted(path) + "has " + std::to_string(found.count) +
                      " values that are NaN or infinite, the first at column " +
                      std::to_string(found.x) + ", row " + std::to_string(found.y) +
                      " from the bottom left";
    warning.expected = "finite numbers; they are used as they are";
    diagnostics.add(std::move(warning));
}

// Destination of row y from the bottom, and a callback after it is decoded; return false to stop.
struct RowsTaker {
    std::function<float*(uint32_t y)> place;
    std::function<bool(uint32_t y)> taken;
};

// Decodes in bands, so that a row is still in the cache when it is converted. The file's first row
// is the top one.
bool decode(const fs::path& path, const Opened& opened, const RowsTaker& rows,
            Diagnostics& diagnostics) {
    const ImageInfo& info = opened.info;
    const WrinkleImageModule* module = opened.reader.get_deleter().module;
    const uint32_t band = module->band(opened.reader.get());
    const size_t values = size_t{info.width} * info.channels;
    const size_t stride = values * bytes_of(info.source);
    const bool any_number = info.source == PixelType::half || info.source == PixelType::float32;
    std::vector<std::byte> stored(std::min(band, info.height) * stride);
    NonFinite non_finite;
    for (uint32_t top = 0; top < info.height; top += band) {
        const uint32_t count = std::min(band, info.height - top);
        char text[512] = "";
        if (!module->read(opened.reader.get(), top, count, stored.data(), {text, sizeof text})) {
            diagnostics.error(quoted(path) + "is damaged or truncated: " + text,
                              "a complete file; export it again");
            return false;
        }
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t y = info.height - 1 - top - i;
            float* row = rows.place(y);
            values_from(info.source, stored.data() + i * stride, {row, values});
            if (any_number) note_non_finite(info, y, row, non_finite);
            if (!rows.taken(y)) return false;
        }
    }
    if (non_finite.count > 0) warn_of_non_finite(path, non_finite, diagnostics);
    return true;
}

std::optional<Image> decode_whole(const fs::path& path, const Opened& opened,
                                  Diagnostics& diagnostics) {
    const ImageInfo& info = opened.info;
    Image image = make_image(info.width, info.height, info.channels, info.source);
    image.has_alpha = info.has_alpha;
    const RowsTaker rows = {[&](uint32_t y) { return image.texel(0, y); },
                            [](uint32_t) { return true; }};
    if (!decode(path, opened, rows, diagnostics)) return {};
    return image;
}

std::optional<ImageInfo> decode_rows(const fs::path& path, const Opened& opened,
                                     const ImageRowSink& take, Diagnostics& diagnostics) {
    std::vector<float> row(size_t{opened.info.width} * opened.info.channels);
    const RowsTaker rows = {[&](uint32_t) { return row.data(); },
                            [&](uint32_t) { return take(opened.info, row.data()); }};
    if (!decode(path, opened, rows, diagnostics)) return {};
    return opened.info;
}

// Returns the result of `read` on the opened file; empty on failure.
template <class Read>
auto opened_and(const fs::path& path, const ImageLimits& limits, Diagnostics& diagnostics,
                Read read) -> decltype(read(std::declval<const Opened&>())) {
    try {
        const Opened opened = open_within(path, limits, diagnostics);
        if (!opened.reader) return {};
        return read(opened);
    } catch (const std::bad_alloc&) {
        diagnostics.error(quoted(path) + "does not fit into memory", "a smaller image");
        return {};
    }
}

// Returns std::nullopt if the environment holds an invalid limit.
std::optional<ImageLimits> usual_limits(Diagnostics& diagnostics) {
    const size_t before = diagnostics.error_count();
    const ImageLimits limits = image_limits_from_environment(diagnostics);
    if (diagnostics.error_count() > before) return {};
    return limits;
}

}  // namespace

uint64_t bytes_with_mips(const ImageInfo& info) {
    const uint64_t pixels = uint64_t{info.width} * info.height;
    const uint64_t packed = info.source == PixelType::u8 ? pixels * sizeof(uint32_t) : 0;
    return pixels * info.channels * sizeof(float) / 3 * 4 + packed;
}

uint64_t bytes_with_mips(const Image& image) {
    return bytes_with_mips({"", image.width, image.height, image.channels, false, image.source});
}

std::optional<ImageInfo> read_image_info(const fs::path& path, const ImageLimits& limits,
                                         Diagnostics& diagnostics) {
    const Opened opened = open_within(path, limits, diagnostics);
    if (!opened.reader) return {};
    return opened.info;
}

std::optional<float> read_image_number(const fs::path& path, const std::string& name) {
    std::string why;
    const ImageFormat format = sniff_format(path, why);
    const WrinkleImageModule* module = image_module(why);
    float value = 0;
    if (!module || !plugin_keeps_numbers(format.plugin)) return {};
    if (!module->number(path.c_str(), format.plugin.c_str(), side_of({}), name.c_str(), &value))
        return {};
    return value;
}

std::optional<Image> load_image(const fs::path& path, const ImageLimits& limits,
                                Diagnostics& diagnostics) {
    return opened_and(path, limits, diagnostics, [&](const Opened& opened) {
        return decode_whole(path, opened, diagnostics);
    });
}

std::optional<Image> load_image(const fs::path& path, Diagnostics& diagnostics) {
    const auto limits = usual_limits(diagnostics);
    return limits ? load_image(path, *limits, diagnostics) : std::nullopt;
}

std::optional<ImageInfo> read_image_rows(const fs::path& path, const ImageLimits& limits,
                                         const ImageRowSink& take, Diagnostics& diagnostics) {
    return opened_and(path, limits, diagnostics, [&](const Opened& opened) {
        return decode_rows(path, opened, take, diagnostics);
    });
}

std::optional<ImageInfo> read_image_rows(const fs::path& path, const ImageRowSink& take,
                                         Diagnostics& diagnostics) {
    const auto limits = usual_limits(diagnostics);
    return limits ? read_image_rows(path, *limits, take, diagnostics) : std::nullopt;
}

}  // namespace wrinkle

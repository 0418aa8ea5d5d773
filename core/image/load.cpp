#include "image/load.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>

#include "image/find_codec.h"
#include "image/formats.h"
#include "image/stored.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

struct CloseReader {
    const WrinkleImageCodec* codec;
    void operator()(WrinkleImageReader* reader) const { codec->close(reader); }
};
using Reader = std::unique_ptr<WrinkleImageReader, CloseReader>;

struct Opened {
    ImageInfo info;
    Reader reader{nullptr, CloseReader{nullptr}};
};

std::string raised(Limit limit, uint64_t value) {
    return "or set " + std::string(row_of(limit).variable) + "=" + std::to_string(value) +
           " to raise the limit";
}

// Returns true if the image is within the limits; else appends an error.
bool within_limits(const fs::path& path, const ImageInfo& info, const ImageLimits& limits,
                   Diagnostics& diagnostics) {
    if (info.width == 0 || info.height == 0) {
        diagnostics.error(RuleId::image_unreadable, quoted(path) + "has no pixels",
                          "at least one pixel");
        return false;
    }
    const auto fits = [&](const char* what, uint64_t found, uint64_t max, Limit limit) {
        if (found > max)
            diagnostics.error(RuleId::over_limit,
                              quoted(path) + "has " + what + " " + std::to_string(found) +
                                  ", over the limit of " + std::to_string(max),
                              "a smaller image, " + raised(limit, found));
        return found <= max;
    };
    const uint64_t pixels = uint64_t{info.width} * info.height;
    if (!fits("width", info.width, limits.max_side, Limit::image_side) ||
        !fits("height", info.height, limits.max_side, Limit::image_side) ||
        !fits("a pixel count of", pixels, limits.max_pixels, Limit::image_pixels) ||
        !fits("a size in memory of", pixels * info.channels * sizeof(float), limits.max_bytes,
              Limit::image_bytes))
        return false;
    const uint64_t found = bytes_with_mips(info), left = limits.left_bytes;
    if (found <= left) return true;
    const uint64_t all = limit_of(Limit::all_images_bytes);
    diagnostics.error(
        RuleId::over_limit,
        quoted(path) + "has a size in memory of " + std::to_string(found) +
            " with its mips, and of the limit of " + std::to_string(all) +
            " for all images of the graph " + std::to_string(left) + " are left",
        "fewer or smaller images, " + raised(Limit::all_images_bytes, all - left + found));
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
        diagnostics.error(RuleId::image_unreadable, quoted(path) + why, readable_formats);
        return opened;
    }
    const WrinkleImageCodec* codec = find_codec(format.plugin, why);
    if (!codec) {
        diagnostics.error(RuleId::environment, quoted(path) + "cannot be read: " + why,
                          library_remedy);
        return opened;
    }
    char text[512] = "";
    WrinkleImageHeader header = {};
    WrinkleImageReader* reader = codec->open(path.c_str(), format.plugin.c_str(), side_of(limits),
                                             &header, {text, sizeof text});
    opened.reader = Reader(reader, CloseReader{codec});
    opened.info = {format.name,     header.width,          header.height,
                   header.channels, header.has_alpha != 0, static_cast<PixelType>(header.type)};
    if ((reader || header.width > 0) && !within_limits(path, opened.info, limits, diagnostics))
        opened.reader.reset();
    else if (!reader)
        diagnostics.error(RuleId::image_unreadable,
                          quoted(path) + "cannot be read as " + format.name + ": " + text,
                          "a complete file with one to four channels; export it again");
    return opened;
}

struct NonFinite {
    size_t count = 0;
    size_t x = 0, y = 0;  // first one, from the bottom left
};

// Rows arrive from the top, so the last row with a non-finite value contains the first one.
void note_non_finite(const ImageInfo& info, uint32_t y, const std::vector<float>& row,
                     NonFinite& found) {
    const auto is_bad = [](float value) { return !std::isfinite(value); };
    const auto count = std::ranges::count_if(row, is_bad);
    if (count == 0) return;
    const auto first = static_cast<size_t>(std::ranges::find_if(row, is_bad) - row.begin());
    found = {found.count + static_cast<size_t>(count), first / info.channels, y};
}

void warn_of_non_finite(const fs::path& path, const NonFinite& found, Diagnostics& diagnostics) {
    diagnostics.add(file_problem(Severity::warning, RuleId::image_values, "",
                                 quoted(path) + "has " + std::to_string(found.count) +
                                     " values that are NaN or infinite, the first at column " +
                                     std::to_string(found.x) + ", row " + std::to_string(found.y) +
                                     " from the bottom left",
                                 "finite numbers; they are used as they are"));
}

// Decodes in bands, so that a row is still in the cache when it is converted.
bool decode(const fs::path& path, const Opened& opened, const ImageRowSink& take,
            Diagnostics& diagnostics) {
    const ImageInfo& info = opened.info;
    const WrinkleImageCodec* codec = opened.reader.get_deleter().codec;
    const uint32_t band = codec->band(opened.reader.get());
    std::vector<float> row(size_t{info.width} * info.channels);
    const size_t stride = row.size() * bytes_of(info.source);
    std::vector<std::byte> stored(std::min(band, info.height) * stride);
    NonFinite non_finite;
    for (uint32_t top = 0; top < info.height; top += band) {
        const uint32_t count = std::min(band, info.height - top);
        char text[512] = "";
        if (!codec->read(opened.reader.get(), top, count, stored.data(), {text, sizeof text})) {
            diagnostics.error(RuleId::image_unreadable,
                              quoted(path) + "is damaged or truncated: " + text,
                              "a complete file; export it again");
            return false;
        }
        for (uint32_t i = 0; i < count; ++i) {
            values_from(info.source, stored.data() + i * stride, row);
            if (!is_integer(info.source))
                note_non_finite(info, info.height - 1 - top - i, row, non_finite);
            if (!take(info, row.data())) return false;
        }
    }
    if (non_finite.count > 0) warn_of_non_finite(path, non_finite, diagnostics);
    return true;
}

// Returns std::nullopt if the environment holds an invalid limit.
std::optional<ImageLimits> usual_limits(Diagnostics& diagnostics) {
    const size_t before = diagnostics.error_count();
    const ImageLimits limits = image_limits_from_environment(diagnostics);
    if (diagnostics.error_count() > before) return {};
    return limits;
}

}  // namespace

ImageLimits image_limits_from_environment(Diagnostics& diagnostics) {
    report_limits(diagnostics);
    return {};
}

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
    float value = 0;
    if (!plugin_keeps_numbers(format.plugin)) return {};
    const WrinkleImageCodec* codec = find_codec(format.plugin, why);
    if (!codec ||
        !codec->number(path.c_str(), format.plugin.c_str(), side_of({}), name.c_str(), &value))
        return {};
    return value;
}

std::optional<Image> load_image(const fs::path& path, const ImageLimits& limits,
                                Diagnostics& diagnostics) {
    Image image;
    uint32_t rows_left = 0;
    const auto take = [&](const ImageInfo& info, const float* row) {
        if (image.empty()) {
            image = make_image(info.width, info.height, info.channels, info.source);
            image.has_alpha = info.has_alpha;
            rows_left = info.height;
        }
        std::copy_n(row, size_t{info.width} * info.channels, image.texel(0, --rows_left));
        return true;
    };
    if (!read_image_rows(path, limits, take, diagnostics)) return {};
    return image;
}

std::optional<Image> load_image(const fs::path& path, Diagnostics& diagnostics) {
    const auto limits = usual_limits(diagnostics);
    return limits ? load_image(path, *limits, diagnostics) : std::nullopt;
}

std::optional<ImageInfo> read_image_rows(const fs::path& path, const ImageLimits& limits,
                                         const ImageRowSink& take, Diagnostics& diagnostics) {
    try {
        const Opened opened = open_within(path, limits, diagnostics);
        if (!opened.reader || !decode(path, opened, take, diagnostics)) return {};
        return opened.info;
    } catch (const std::bad_alloc&) {
        diagnostics.error(RuleId::over_limit, quoted(path) + "does not fit into memory",
                          "a smaller image");
        return {};
    }
}

std::optional<ImageInfo> read_image_rows(const fs::path& path, const ImageRowSink& take,
                                         Diagnostics& diagnostics) {
    const auto limits = usual_limits(diagnostics);
    return limits ? read_image_rows(path, *limits, take, diagnostics) : std::nullopt;
}

}  // namespace wrinkle

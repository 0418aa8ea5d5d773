#include "maps/convert.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/load.h"
#include "maps/map_writer.h"
#include "maps/poisson.h"
#include "maps/texels.h"

namespace wrinkle::maps {
namespace fs = std::filesystem;

namespace {

struct Range {
    float low = std::numeric_limits<float>::infinity();
    float high = -std::numeric_limits<float>::infinity();
};

// Range of all finite values.
Range range_of(const Rows& rows, const Target& target) {
    const size_t count = size_t{rows.width()} * mean_channels(target.kind);
    return tbb::parallel_reduce(
        tbb::blocked_range<uint32_t>(0, rows.height()), Range{},
        [&](const tbb::blocked_range<uint32_t>& part, Range range) {
            std::vector<float> values(count);
            for (uint32_t y = part.begin(); y < part.end(); ++y) {
                mean_row(rows, target, y, values.data());
                for (const float value : values)
                    if (std::isfinite(value)) {
                        range.low = std::min(range.low, value);
                        range.high = std::max(range.high, value);
                    }
            }
            return range;
        },
        [](const Range& a, const Range& b) {
            return Range{std::min(a.low, b.low), std::max(a.high, b.high)};
        });
}

// Encoding of integer files: slopes symmetric about 0, heights from the lowest to the highest.
Stored stored_of(const Rows& rows, const Target& target) {
    if (!is_integer(target.type) || target.kind == Kind::normal) return {};
    const Range range = range_of(rows, target);
    if (range.low > range.high) return {};
    if (target.kind == Kind::height)
        return {range.high > range.low ? range.high - range.low : 1, range.low};
    const float steepest = std::max(std::abs(range.low), std::abs(range.high));
    const float scale = steepest > 0 ? steepest : 1;
    return {2 * scale, -scale};
}

std::vector<ImageNumber> numbers_of(const Target& target, const Stored& stored) {
    if (!is_integer(target.type)) return {};
    if (target.kind == Kind::derivative || target.kind == Kind::moments)
        return {{scale_name, stored.scale / 2}};
    if (target.kind == Kind::height)
        return {{scale_name, stored.scale}, {offset_name, stored.offset}};
    return {};
}

bool write_map(const Rows& rows, const Target& target, const fs::path& path,
               Diagnostics& diagnostics) {
    const Stored stored = stored_of(rows, target);
    WriterOptions options;
    options.width = rows.width();
    options.height = rows.height();
    options.channels = file_channel_names(target, path.extension() != ".png");
    options.type = target.type;
    options.compression = target.compression;
    options.mips = target.mips;
    options.tile = target.tile > 0 || !target.mips ? target.tile : 64;
    options.numbers = numbers_of(target, stored);
    auto writer = ImageWriter::open(path, options, diagnostics);
    if (!writer) return false;
    const auto channels = static_cast<uint32_t>(options.channels.size());
    return MapWriter(rows, target, stored, channels, *writer).write(diagnostics);
}

Image solved(const Rows& rows) {
    const uint32_t width = rows.width(), height = rows.height();
    std::vector<float> du(size_t{width} * height), dv(du.size());
    tbb::parallel_for(0u, height, [&](uint32_t y) {
        rows.slopes(y, &du[size_t{y} * width], &dv[size_t{y} * width]);
    });
    // Slopes are per unit of length; the solver expects slopes per texel.
    const Source& source = rows.source();
    multiply(du.data(), source.texel_width, dv.data(), source.texel_height, du.size());
    Image image = make_image(width, height, 1);
    image.data = height_of_slopes(std::move(du), std::move(dv), width, height, source.wrap);
    return image;
}

}  // namespace

void read_stored_scale(const fs::path& path, Source& source) {
    const float scale = read_image_number(path, scale_name).value_or(1);
    if (source.kind == Kind::derivative) source.stored_scale = scale;
    if (source.kind != Kind::height) return;
    const float offset = read_image_number(path, offset_name).value_or(0);
    source.offset = offset * source.factor;
    source.factor *= scale;
}

bool convert(const Source& source, const Target& target, const fs::path& path,
             Diagnostics& diagnostics) {
    const Rows rows(source);
    if (target.kind != Kind::height || rows.heights(0))
        return write_map(rows, target, path, diagnostics);
    const Image height = solved(rows);
    Source of_height;
    of_height.image = &height;
    return write_map(Rows(of_height), target, path, diagnostics);
}

}  // namespace wrinkle::maps

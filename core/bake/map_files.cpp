#include "bake/map_files.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "image/stored.h"

namespace wrinkle {
namespace {

// Half a step of 16 bits: smaller excess is lost to rounding and is not reported.
constexpr float rounding = 0.5F / 65535;

void note_clamped(std::span<const float> values, Clamped& clamped) {
    for (const float value : values) {
        if (!(value < -rounding || value > 1 + rounding)) continue;
        ++clamped.numbers;
        clamped.least = std::min(clamped.least, value);
        clamped.greatest = std::max(clamped.greatest, value);
    }
}

}  // namespace

void Clamped::add(const Clamped& other) {
    numbers += other.numbers;
    least = std::min(least, other.least);
    greatest = std::max(greatest, other.greatest);
}

std::vector<std::byte> stored_rows(const BakedMap& map, PixelType type, const BakedRows& rows,
                                   uint32_t width, size_t lanes, Clamped& clamped) {
    const size_t numbers = size_t{width} * map.channels.size();
    std::vector<std::byte> bytes(numbers * rows.count * bytes_of(type));
    tbb::combinable<Clamped> found;
    const auto store = [&](const tbb::blocked_range<uint32_t>& part) {
        std::vector<float> values(numbers);
        for (uint32_t row = part.begin(); row < part.end(); ++row) {
            const size_t first = size_t{row} * width;
            store_map(map, rows.values + first * lanes, rows.covered + first, width, values.data());
            if (is_integer(type)) note_clamped(values, found.local());
            store_values(type, values, bytes.data() + row * numbers * bytes_of(type));
        }
    };
    tbb::parallel_for(tbb::blocked_range<uint32_t>(0, rows.count, 8), store);
    found.combine_each([&](const Clamped& each) { clamped.add(each); });
    return bytes;
}

std::filesystem::path map_path(const std::filesystem::path& out, bool one_file,
                               const std::string& name, const std::string& suffix,
                               const std::string& extension) {
    std::filesystem::path path = out;
    if (one_file) return path.replace_extension(suffix + extension);
    return path / (name + suffix + extension);
}

WriterOptions writer_options(const BakedMap& map, PixelType type, uint32_t width, uint32_t height,
                             double scale) {
    WriterOptions options;
    options.width = width;
    options.height = height;
    for (const MapChannel& channel : map.channels)
        options.channels.push_back(channel.name);
    options.has_alpha = map.has_alpha;
    options.type = type;
    options.numbers.push_back({layout_mark, 1});
    if (scale != 1) options.numbers.push_back({"wrinkle:scale", static_cast<float>(scale)});
    return options;
}

std::optional<std::vector<ImageWriter>> open_maps(const std::vector<MapFile>& files,
                                                  Diagnostics& diagnostics) {
    std::vector<ImageWriter> writers;
    for (const MapFile& file : files) {
        std::error_code error;
        const std::filesystem::path folder = file.path.parent_path();
        if (!folder.empty()) std::filesystem::create_directories(folder, error);
        auto writer = ImageWriter::open(file.path, file.options, diagnostics);
        if (!writer) return {};
        writers.push_back(std::move(*writer));
    }
    return writers;
}

bool finish_maps(std::vector<ImageWriter>& writers, Diagnostics& diagnostics) {
    return std::ranges::all_of(writers,
                               [&](ImageWriter& writer) { return writer.close(diagnostics); }) &&
           std::ranges::all_of(writers,
                               [&](ImageWriter& writer) { return writer.finish(diagnostics); });
}

}  // namespace wrinkle

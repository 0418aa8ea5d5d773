#include "maps/map_writer.h"

#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>

#include "image/mips.h"
#include "image/stored.h"

namespace wrinkle::maps {

namespace {

constexpr uint32_t rows_at_once = 64;

// First and last row, from the top, that row `row` (from the top) of the next level covers.
struct FinerRows {
    uint32_t first = 0, last = 0;
};

FinerRows finer_rows(uint32_t finer_height, uint32_t height, uint32_t row) {
    const CoveredRows covered = covered_rows(finer_height, height - 1 - row);
    const uint32_t last = finer_height - 1 - covered.first;
    return {last + 1 - covered.count, last};
}

}  // namespace

MapWriter::MapWriter(const Rows& rows, const Target& target, const Stored& stored,
                     uint32_t channels, ImageWriter& writer)
    : rows_(rows),
      target_(target),
      stored_(stored),
      writer_(writer),
      means_(mean_channels(target.kind)),
      channels_(channels),
      plain_(is_plain(target, channels_)) {
    uint32_t width = rows.width(), height = rows.height();
    for (uint32_t i = 0; i < writer.levels(); ++i) {
        levels_.push_back({width, height});
        width = next_mip_size(width);
        height = next_mip_size(height);
    }
}

bool MapWriter::write(Diagnostics& diagnostics) {
    tbb::task_group writing;
    bool written = true;
    for (uint32_t turn = 0; levels_[0].made < rows_.height(); turn ^= 1) {
        make(turn);
        writing.wait();
        if (!written) return false;
        writing.run([&, turn] { written = put(turn, diagnostics); });
    }
    writing.wait();
    return written && writer_.finish(diagnostics);
}

void MapWriter::make(uint32_t turn) {
    make_first(turn);
    for (size_t i = 1; i < levels_.size(); ++i)
        make_next(levels_[i - 1], levels_[i], turn);
}

// Allocates `count` new rows after a copy of the last `kept` rows of the previous band.
void MapWriter::begin(Level& level, uint32_t kept, uint32_t count, uint32_t turn) const {
    Band &band = level.bands[turn], &before = level.bands[turn ^ 1];
    const size_t row = size_t{level.width} * means_;
    band.kept = kept;
    band.count = count;
    band.means.resize((kept + count) * row);
    const size_t end = (before.kept + before.count) * row;
    std::copy(before.means.begin() + (end - kept * row), before.means.begin() + end,
              band.means.begin());
    if (!plain_ || target_.type != PixelType::float32)
        band.stored.resize(size_t{level.width} * channels_ * bytes_of(target_.type) * count);
    level.made += count;
}

// Returns the number of newest rows of a level that the next level still needs.
uint32_t MapWriter::rows_needed(uint32_t index) const {
    const Level& level = levels_[index];
    if (index + 1 == levels_.size()) return 0;
    const Level& next = levels_[index + 1];
    if (next.made == next.height) return 0;
    return level.made - finer_rows(level.height, next.height, next.made).first;
}

void MapWriter::make_first(uint32_t turn) {
    Level& level = levels_[0];
    const uint32_t top = level.made;
    begin(level, rows_needed(0), std::min(rows_at_once, level.height - top), turn);
    Band& band = level.bands[turn];
    tbb::parallel_for(0u, band.count, [&](uint32_t i) {
        mean_row(rows_, target_, level.height - 1 - top - i,
                 &band.means[(band.kept + i) * size_t{level.width} * means_]);
        store(level, band, i);
    });
}

// Returns the number of rows of a level that can be computed from the finer one.
uint32_t MapWriter::rows_ready(const Level& finer, const Level& level) const {
    uint32_t row = level.made;
    while (row < level.height && finer_rows(finer.height, level.height, row).last < finer.made)
        ++row;
    return row - level.made;
}

void MapWriter::make_next(const Level& finer, Level& level, uint32_t turn) const {
    const uint32_t top = level.made;
    const auto index = static_cast<uint32_t>(&level - levels_.data());
    begin(level, rows_needed(index), rows_ready(finer, level), turn);
    const Band& from = finer.bands[turn];
    const uint32_t from_top = finer.made - from.kept - from.count;
    Band& band = level.bands[turn];
    tbb::parallel_for(0u, band.count, [&](uint32_t i) {
        const FinerRows used = finer_rows(finer.height, level.height, top + i);
        const float* rows[3] = {};  // bottom up
        for (uint32_t row = used.last + 1, j = 0; row-- > used.first; ++j)
            rows[j] = &from.means[(row - from_top) * size_t{finer.width} * means_];
        half_row(finer.width, finer.height, means_, level.height - 1 - top - i, rows,
                 &band.means[(band.kept + i) * size_t{level.width} * means_]);
        store(level, band, i);
    });
}

// Encodes new row `row` of a band for the file.
void MapWriter::store(const Level& level, Band& band, uint32_t row) const {
    if (band.stored.empty()) return;
    const float* means = &band.means[(band.kept + row) * size_t{level.width} * means_];
    const size_t values = size_t{level.width} * channels_;
    thread_local std::vector<float> encoded;
    if (!plain_) {
        encoded.resize(values);
        encode(target_, stored_, means, level.width, channels_, encoded.data());
    }
    store_values(target_.type, {plain_ ? means : encoded.data(), values},
                 &band.stored[row * values * bytes_of(target_.type)]);
}

bool MapWriter::put(uint32_t turn, Diagnostics& diagnostics) {
    for (uint32_t i = 0; i < levels_.size(); ++i) {
        const Band& band = levels_[i].bands[turn];
        const size_t kept = size_t{band.kept} * levels_[i].width * means_;
        const std::span<const float> made(band.means.data() + kept, band.means.size() - kept);
        const std::span<const std::byte> stored =
            band.stored.empty() ? std::as_bytes(made) : std::span(band.stored);
        if (!writer_.write_stored(stored, diagnostics, i)) return false;
    }
    return true;
}

}  // namespace wrinkle::maps

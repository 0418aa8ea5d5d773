#include "maps/map_writer.h"

#include <tbb/parallel_for.h>

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
      channels_(channels) {
    for (uint32_t i = 0; i < writer.levels(); ++i)
        levels_.push_back({writer.width(i), writer.rows_left(i)});
}

bool MapWriter::write(Diagnostics& diagnostics) {
    while (levels_[0].made < rows_.height()) {
        for (uint32_t i = 0; i < levels_.size(); ++i) {
            const uint32_t count = i == 0 ? make_first() : make_next(levels_[i - 1], levels_[i]);
            if (!put(i, count, diagnostics)) return false;
        }
        for (uint32_t i = 0; i < levels_.size(); ++i)
            drop_unneeded(i);
    }
    return writer_.finish(diagnostics);
}

// Makes room for the next rows of a level; returns the first number of the first one.
float* MapWriter::add_rows(Level& level, uint32_t count) const {
    const size_t end = level.means.size();
    level.means.resize(end + count * row_size(level));
    level.made += count;
    return level.means.data() + end;
}

// Both return the number of new rows.
uint32_t MapWriter::make_first() {
    Level& level = levels_[0];
    const uint32_t bottom = level.height - level.made;  // rows count from the bottom in an image
    const uint32_t count = std::min(rows_at_once, bottom);
    float* out = add_rows(level, count);
    tbb::parallel_for(0u, count, [&](uint32_t i) {
        mean_row(rows_, target_, bottom - 1 - i, out + i * row_size(level));
    });
    return count;
}

uint32_t MapWriter::make_next(const Level& finer, Level& level) const {
    const uint32_t first = level.made;
    uint32_t end = first;
    while (end < level.height && finer_rows(finer.height, level.height, end).last < finer.made)
        ++end;
    float* out = add_rows(level, end - first);
    const float* finer_end = finer.means.data() + finer.means.size();
    tbb::parallel_for(first, end, [&](uint32_t row) {
        const FinerRows used = finer_rows(finer.height, level.height, row);
        const float* rows[3] = {};  // bottom up
        for (uint32_t y = used.last + 1, j = 0; y-- > used.first; ++j)
            rows[j] = finer_end - (finer.made - y) * row_size(finer);
        half_row(finer.width, finer.height, means_, level.height - 1 - row, rows,
                 out + (row - first) * row_size(level));
    });
    return end - first;
}

// Writes the last `count` rows of a level.
bool MapWriter::put(uint32_t index, uint32_t count, Diagnostics& diagnostics) {
    const Level& level = levels_[index];
    const size_t values = size_t{level.width} * channels_;
    const size_t row_bytes = values * bytes_of(target_.type);
    const float* means = level.means.data() + level.means.size() - count * row_size(level);
    encoded_.resize(count * row_bytes);
    tbb::parallel_for(0u, count, [&](uint32_t row) {
        std::vector<float> numbers(values);
        encode(target_, stored_, means + row * row_size(level), level.width, channels_,
               numbers.data());
        store_values(target_.type, numbers, encoded_.data() + row * row_bytes);
    });
    return writer_.write_stored(encoded_, diagnostics, index);
}

// Drops the rows of a level that no further row of the next level covers.
void MapWriter::drop_unneeded(uint32_t index) {
    Level& level = levels_[index];
    uint32_t needed = 0;
    if (index + 1 < levels_.size()) {
        const Level& next = levels_[index + 1];
        if (next.made < next.height)
            needed = level.made - finer_rows(level.height, next.height, next.made).first;
    }
    const auto end = level.means.end() - static_cast<ptrdiff_t>(needed * row_size(level));
    level.means.erase(level.means.begin(), end);
}

}  // namespace wrinkle::maps

// Writes a map with all its mip levels to a file, in one pass over its rows.
//
// Rows are computed in bands from the top; each band also completes rows of the coarser levels. So
// no level is in memory completely, and each row is computed once. Uses all cores.
#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "image/writer.h"
#include "maps/convert.h"
#include "maps/map.h"
#include "maps/texels.h"

namespace wrinkle::maps {

class MapWriter {
public:
    // The writer must have the size of `rows` and `channels` channels. All references must outlive
    // this object.
    MapWriter(const Rows& rows, const Target& target, const Stored& stored, uint32_t channels,
              ImageWriter& writer);

    bool write(Diagnostics& diagnostics);  // calls finish() of the writer

private:
    struct Level {
        uint32_t width = 0, height = 0;
        uint32_t made = 0;              // rows so far, from the top
        std::vector<float> means = {};  // the last of these rows
    };

    size_t row_size(const Level& level) const { return size_t{level.width} * means_; }
    float* add_rows(Level& level, uint32_t count) const;
    uint32_t make_first();
    uint32_t make_next(const Level& finer, Level& level) const;
    bool put(uint32_t index, uint32_t count, Diagnostics& diagnostics);
    void drop_unneeded(uint32_t index);

    const Rows& rows_;
    const Target& target_;
    const Stored& stored_;
    ImageWriter& writer_;
    uint32_t means_;     // averaged numbers per texel
    uint32_t channels_;  // channels of the file
    std::vector<Level> levels_;
    std::vector<std::byte> encoded_;  // rows in the file's type
};

}  // namespace wrinkle::maps

// Writes a map with all its mip levels to a file, in one pass over its rows.
//
// Rows are computed in bands from the top; each band also completes rows of the coarser levels. One
// band is computed while the previous one is written. So no level is in memory completely, and each
// row is computed once.
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
    struct Band {
        uint32_t kept = 0;              // rows of the previous band that the next level still needs
        uint32_t count = 0;             // new rows, after those
        std::vector<float> means;       // previous rows, then new ones
        std::vector<std::byte> stored;  // new rows, encoded for the file; empty: as `means`
    };
    struct Level {
        uint32_t width = 0, height = 0;
        uint32_t made = 0;  // rows so far, from the top
        Band bands[2] = {};
    };

    void make(uint32_t turn);
    void begin(Level& level, uint32_t kept, uint32_t count, uint32_t turn) const;
    void make_first(uint32_t turn);
    void make_next(const Level& finer, Level& level, uint32_t turn) const;
    void store(const Level& level, Band& band, uint32_t row) const;
    uint32_t rows_ready(const Level& finer, const Level& level) const;
    uint32_t rows_needed(uint32_t index) const;
    bool put(uint32_t turn, Diagnostics& diagnostics);

    const Rows& rows_;
    const Target& target_;
    const Stored& stored_;
    ImageWriter& writer_;
    uint32_t means_;     // averaged numbers per texel
    uint32_t channels_;  // channels of the file
    bool plain_;         // means are stored without encoding
    std::vector<Level> levels_;
};

}  // namespace wrinkle::maps

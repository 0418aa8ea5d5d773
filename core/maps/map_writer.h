// A map on its way to a file with all its levels, in one pass over its rows.
//
// Rows are made a band at a time from the top, and with each band what it completes of every
// coarser level; one band is made while the one before it is written. So no level is ever in memory
// as a whole, and no row is computed twice.
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
    // The writer has the size of the rows and so many channels. All that is referred to outlives
    // this.
    MapWriter(const Rows& rows, const Target& target, const Stored& stored, uint32_t channels,
              ImageWriter& writer);

    bool write(Diagnostics& diagnostics);  // and finish()

private:
    struct Band {
        uint32_t kept = 0;              // rows of the band before that the next level still needs
        uint32_t count = 0;             // new ones, after those
        std::vector<float> means;       // of both
        std::vector<std::byte> stored;  // new ones as the file holds them, unless these are means
    };
    struct Level {
        uint32_t width = 0, height = 0;
        uint32_t made = 0;  // rows, from the top
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
    uint32_t means_;     // numbers of a texel that are averaged
    uint32_t channels_;  // and those of the file
    bool plain_;         // which are the same
    std::vector<Level> levels_;
};

}  // namespace wrinkle::maps

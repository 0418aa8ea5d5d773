// An OpenEXR file on its way to the disk, through OpenEXR's C library. A chunk is what is packed
// and compressed as one: a tile, or a block of scan lines. Chunks are made on all threads and go to
// the file in the order of their rows, so equal rows give equal bytes with any number of threads.
//
// zip and zips are libdeflate's work, in the format that every reader of OpenEXR knows and in a
// third of the time that OpenEXR's own zlib takes; rle and piz are OpenEXR's.
//
// Rows are interleaved, in the order of the caller's channels; the file sorts channels by name, one
// after the other within each row of a chunk. Functions throw Failure.
#pragma once

#include <OpenEXR/openexr.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "image/oiio/exr_chunk.h"
#include "image/oiio/image_module.h"
#include "image/oiio/output_file.h"

namespace wrinkle::oiio {

class ExrFile {
public:
    ExrFile(OutputFile& file, const char* path, const WrinkleImageWrite& what);  // and its header

    // Rows `first` to `first` + `count` of a level, whole chunks. Each level's rows come from the
    // top, the levels in any order.
    void write(uint32_t level, const std::byte* rows, uint32_t first, uint32_t count);

    // When all rows of all levels are there.
    void close();

private:
    struct Rows {
        uint32_t level = 0, first = 0, count = 0;
        const std::byte* texels = nullptr;
        uint32_t width = 0;   // of the level
        uint32_t across = 0;  // chunks from left to right
        size_t bytes = 0;     // of one row
    };
    struct Slot {                                      // of a chunk that is being made
        uint32_t x = 0, y = 0, width = 0, height = 0;  // in texels of its level
        const std::byte* texels = nullptr;
        std::vector<std::byte> packed, compressed;
        std::span<const std::byte> stored;  // one of the two
    };
    struct FinishContext {
        void operator()(exr_context_t context) const;
    };

    void declare(const WrinkleImageWrite& what);
    void declare_channels(const WrinkleImageWrite& what);
    void sort_channels(const WrinkleImageWrite& what);
    void place(const Rows& rows, uint32_t index, Slot& slot) const;
    void make(const Rows& rows, Slot& slot) const;
    void encode(const Rows& rows, Slot& slot) const;
    void put(const Rows& rows, const Slot& slot);
    void put_all(const Rows& rows);

    std::unique_ptr<_priv_exr_context_t, FinishContext> context_;
    exr_compression_t compression_ = EXR_COMPRESSION_NONE;
    ChunkLayout layout_;
    uint32_t width_ = 0, height_ = 0;
    uint32_t tile_ = 0;            // 0: scan lines
    uint32_t rows_per_chunk_ = 0;  // of a chunk that is not the last
    int threads_ = 0;              // 0: as many as there are
    std::vector<Slot> slots_;
};

}  // namespace wrinkle::oiio

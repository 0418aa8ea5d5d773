// Writes an OpenEXR file through OpenEXR's C library. A chunk is the unit of packing and
// compression: a tile, or a block of scan lines. Chunks are encoded on all threads and written in
// the order of their rows, so equal rows give equal bytes for any number of threads.
//
// zip and zips use libdeflate, which writes the standard format in a third of the time of OpenEXR's
// own zlib; rle and piz use OpenEXR.
// Rows are interleaved, in the order of the caller's channels; the file sorts channels by name, one
// after the other within each row of a chunk. Functions throw Failure.
#pragma once

#include <OpenEXR/openexr.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "image/codec.h"
#include "image/oiio/output_file.h"

namespace wrinkle::oiio {

class ExrFile {
public:
    // Writes the header.
    ExrFile(OutputFile& file, const char* path, const WriterOptions& options, bool mips);

    // Writes rows `first` to `first` + `count` of a level; precondition: complete chunks. Each
    // level's rows arrive from the top, the levels in any order.
    void write(uint32_t level, const std::byte* rows, uint32_t first, uint32_t count);

    // Precondition: all rows of all levels have been written.
    void close();

private:
    struct Rows {
        uint32_t level = 0, first = 0, count = 0;
        const std::byte* texels = nullptr;
        uint32_t width = 0;   // width of the level
        uint32_t across = 0;  // chunks from left to right
        size_t bytes = 0;     // bytes of one row
    };
    struct Slot {                                      // a chunk being encoded
        uint32_t x = 0, y = 0, width = 0, height = 0;  // in texels of its level
        const std::byte* texels = nullptr;
        std::vector<std::byte> stored;
    };
    struct FinishContext {
        void operator()(exr_context_t context) const;
    };

    size_t texel_bytes() const { return order_.size() * value_bytes_; }
    void declare(const WriterOptions& options, bool mips);
    void declare_channels(const WriterOptions& options);
    void sort_channels(const WriterOptions& options);
    void locate(const Rows& rows, uint32_t index, Slot& slot) const;
    void encode(const Rows& rows, Slot& slot) const;
    void put(const Rows& rows, const Slot& slot);
    void put_all(const Rows& rows);

    std::unique_ptr<_priv_exr_context_t, FinishContext> context_;
    exr_compression_t compression_ = EXR_COMPRESSION_NONE;
    std::vector<uint32_t> order_;  // the caller's channels in the file's order
    size_t value_bytes_ = 0;       // 2 or 4
    uint32_t width_ = 0, height_ = 0;
    uint32_t tile_ = 0;            // 0: scan lines
    uint32_t rows_per_chunk_ = 0;  // except in the last chunk
    int threads_ = 0;              // 0: all available
    std::vector<Slot> slots_;
};

}  // namespace wrinkle::oiio

// Bytes of one chunk of an OpenEXR file: packed from interleaved texels, and zipped.
//
// In packed form, each row of the chunk holds its channels one after the other in the file's order.
// zip() stores the bytes with even indices before those with odd ones, replaces each byte by its
// difference from the previous one (+ 128) and compresses the result to a zlib stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wrinkle::oiio {

struct ChunkLayout {
    std::vector<uint32_t> order;  // the caller's channels in the file's order
    size_t value_bytes = 0;       // 2 or 4

    size_t texel_bytes() const { return order.size() * value_bytes; }
};

// `texels` points to the chunk's first texel; `row_bytes` is the distance between rows.
void pack(const ChunkLayout& layout, const std::byte* texels, size_t row_bytes, uint32_t width,
          uint32_t height, std::vector<std::byte>& packed);

// Returns false if the stream would not be shorter; the file then stores `packed`.
bool zip(const std::vector<std::byte>& packed, std::vector<std::byte>& compressed);

}  // namespace wrinkle::oiio

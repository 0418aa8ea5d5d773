// The bytes of one chunk of an OpenEXR file: packed from interleaved texels, and zipped.
//
// Packed, each row of the chunk holds its channels one after the other in the file's order. For
// zip the bytes with even places come before those with odd ones, each stands as its difference
// from the one before it, and the whole is a zlib stream.
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

// `texels` is the chunk's first, `row_bytes` lead from one of its rows to the next.
void pack(const ChunkLayout& layout, const std::byte* texels, size_t row_bytes, uint32_t width,
          uint32_t height, std::vector<std::byte>& packed);

// False where the stream would not be shorter; the file then holds `packed`.
bool zip(const std::vector<std::byte>& packed, std::vector<std::byte>& compressed);

}  // namespace wrinkle::oiio

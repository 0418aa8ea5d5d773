#include "image/oiio/exr_chunk.h"

#include <libdeflate.h>

#include <bit>
#include <cstring>
#include <memory>
#include <new>

namespace wrinkle::oiio {

namespace {

static_assert(std::endian::native == std::endian::little, "OpenEXR's values are little-endian");

// On slope maps within 4 % of the size of zlib level 4, OpenEXR's default, and three times as fast.
constexpr int zip_level = 1;

struct FreeCompressor {
    void operator()(libdeflate_compressor* compressor) const {
        libdeflate_free_compressor(compressor);
    }
};

libdeflate_compressor* compressor_of_thread() {
    thread_local const std::unique_ptr<libdeflate_compressor, FreeCompressor> the(
        libdeflate_alloc_compressor(zip_level));
    if (!the) throw std::bad_alloc();
    return the.get();
}

template <typename Value>
void pack_values(const ChunkLayout& layout, const std::byte* texels, size_t row_bytes,
                 uint32_t width, uint32_t height, std::byte* out) {
    const size_t step = layout.order.size();
    for (uint32_t y = 0; y < height; ++y, texels += row_bytes)
        for (const uint32_t channel : layout.order) {
            const std::byte* in = texels + channel * sizeof(Value);
            for (uint32_t x = 0; x < width; ++x)
                std::memcpy(out + x * sizeof(Value), in + x * step * sizeof(Value), sizeof(Value));
            out += width * sizeof(Value);
        }
}

uint8_t difference(uint8_t value, uint8_t before) {
    return static_cast<uint8_t>(value - before + 128);
}

// Precondition: the size is even and not 0, as for all chunks of OpenEXR.
void split_and_differ(const std::vector<std::byte>& packed, std::vector<uint8_t>& out) {
    const auto* in = reinterpret_cast<const uint8_t*>(packed.data());
    const size_t half = packed.size() / 2;
    out.resize(packed.size());
    uint8_t *even = out.data(), *odd = even + half;
    even[0] = in[0];
    odd[0] = difference(in[1], in[packed.size() - 2]);
    for (size_t i = 1; i < half; ++i) {
        even[i] = difference(in[2 * i], in[2 * i - 2]);
        odd[i] = difference(in[2 * i + 1], in[2 * i - 1]);
    }
}

}  // namespace

void pack(const ChunkLayout& layout, const std::byte* texels, size_t row_bytes, uint32_t width,
          uint32_t height, std::vector<std::byte>& packed) {
    packed.resize(size_t{width} * height * layout.texel_bytes());
    const auto pack_all = layout.value_bytes == 2 ? pack_values<uint16_t> : pack_values<uint32_t>;
    pack_all(layout, texels, row_bytes, width, height, packed.data());
}

bool zip(const std::vector<std::byte>& packed, std::vector<std::byte>& compressed) {
    thread_local std::vector<uint8_t> differences;
    split_and_differ(packed, differences);
    compressed.resize(packed.size() - 1);
    const size_t size =
        libdeflate_zlib_compress(compressor_of_thread(), differences.data(), differences.size(),
                                 compressed.data(), compressed.size());
    compressed.resize(size);
    return size > 0;
}

}  // namespace wrinkle::oiio

// A mip chain in the layout that float tiles sample. Values are those of the chain, bit for bit.
//
// Opaque 8-bit images store their finest level in four bytes per texel, with a border of one texel
// filled by the wrap mode: a quarter of the memory traffic of sampling, neighbouring texels in one
// load, and no border checks. All other levels are read from the chain. Packed levels are built on
// first use and cached, one for `repeat` and one for the other modes; thread-safe.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "base/texture_options.h"
#include "image/mips.h"

namespace wrinkle {

inline constexpr std::array packed_shift = {0, 11, 22};
inline constexpr size_t packed_padding = 16;  // padding after the last texel, read by vector loads

// A level in one of two formats; the other's pointer is null. Texels are stored in rows, y up.
struct TexelLevel {
    // Three times each byte in ten bits, r lowest, at packed_shift.
    // Texel (x, y) has index (y + 1) * (width + 2) + x + 1.
    const uint32_t* packed = nullptr;
    const float* floats = nullptr;  // `stored` channels per texel, as in the image
    int32_t width = 0, height = 0, stored = 0;
    bool has_alpha = false;
};

class PackedMipChain {
public:
    explicit PackedMipChain(std::shared_ptr<const MipChain> chain) : chain_(std::move(chain)) {}

    const std::shared_ptr<const MipChain>& chain() const { return chain_; }
    // Returns an empty span if the image is too large for 32-bit indices.
    std::span<const TexelLevel> levels(Wrap wrap) const;

private:
    struct Form {
        std::once_flag once;
        std::vector<TexelLevel> levels;
        std::vector<uint32_t> packed;
    };
    void make(Wrap wrap, Form& form) const;

    std::shared_ptr<const MipChain> chain_;
    mutable std::array<Form, 2> forms_;  // repeat; clamp and mirror
};

}  // namespace wrinkle

// A mip chain in the layout that float tiles sample. Values are those of the chain, bit for bit.
//
// The finest level of an opaque 8-bit image is packed in four bytes per texel (RGBA floats take
// 16), with a border of one texel filled by the wrap mode: less memory traffic, neighbouring texels
// in one load, no border checks. All other levels are read from the chain. Packed levels are built
// on first use and cached, one for `repeat` and one for the other modes; thread-safe.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "base/texture_options.h"
#include "image/mips.h"

namespace wrinkle {

// First bits of r, g and b in a packed texel.
inline constexpr std::array packed_shift = {0, 11, 22};
inline constexpr size_t packed_padding = 16;  // padding after the last texel, read by vector loads

// A level in one of two formats; the other's pointer is null. Texels are stored in rows, y up.
struct TexelLevel {
    // Each channel is a field of ten bits at packed_shift that holds 3 * byte, from which one
    // multiplication gives byte / 255 exactly rounded. Texel (x, y) has index
    // (y + 1) * (width + 2) + x + 1.
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

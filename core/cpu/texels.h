// A mip chain as tiles of floats read it. The values are the chain's own, to the last bit.
//
// Opaque pictures of 8 bits keep their finest level in four bytes a texel, with a border of one
// texel around it as the wrap mode continues the picture: a quarter of the memory that sampling
// passes through, neighbours in one read, and no border to look out for. Everything else is read
// where the chain has it. Packed levels are made by whoever asks first and then kept, one for
// `repeat` and one for the other modes; threads may ask at once.
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
inline constexpr size_t packed_behind = 16;  // behind the last texel as many may be read

// A level in one of two forms; the other's pointer is null. Texels stand row by row, y upward.
struct TexelLevel {
    // Three times each byte in ten bits, r lowest, at packed_shift. Texel (x, y) is number
    // (y + 1) * (width + 2) + x + 1.
    const uint32_t* packed = nullptr;
    const float* floats = nullptr;  // `stored` channels a texel, as the image has them
    int32_t width = 0, height = 0, stored = 0;
    bool has_alpha = false;
};

class Texels {
public:
    explicit Texels(std::shared_ptr<const MipChain> chain) : chain_(std::move(chain)) {}

    const std::shared_ptr<const MipChain>& chain() const { return chain_; }
    // Empty where the picture is too large for 32-bit places.
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

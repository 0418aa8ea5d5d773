// Textures in GPU memory, and how they are looked up.
//
// A picture goes up level by level as its MipChain has it, always with four channels: 8 and 16-bit
// sources as 16-bit integers (8-bit textures are filtered coarsely by some drivers), half and float
// sources as 32-bit floats, so that filtered values equal the CPU's. Wrap and filter are a Lookup,
// apart from the texels: one picture may be read in several ways.
#pragma once

#include <cstdint>
#include <span>

#include "base/texture_options.h"
#include "image/mips.h"

namespace wrinkle::gpu {

class Texture {
public:
    static Texture upload(const MipChain& chain);  // of an empty chain: one black texel
    // 32-bit floats, four per texel, row by row from the bottom; one level, for texelFetch.
    static Texture of_floats(int width, int height, std::span<const float> rgba);

    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&& other) noexcept;
    ~Texture();

    void bind(int unit) const;
    uint32_t id() const { return id_; }

private:
    explicit Texture(uint32_t id) : id_(id) {}
    uint32_t id_ = 0;
};

// linear is trilinear; nearest takes the nearest texel of the nearest level.
class Lookup {
public:
    Lookup(Wrap wrap, Filter filter);
    Lookup(Lookup&& other) noexcept;
    Lookup& operator=(Lookup&& other) noexcept;
    ~Lookup();

    void bind(int unit) const;

private:
    uint32_t id_ = 0;
};

}  // namespace wrinkle::gpu

// Textures in GPU memory, and how they are looked up.
//
// A picture goes up level by level as its MipChain has it, in 32-bit floats, so that filtered
// values equal the CPU's: drivers filter integers in steps of their own width, and a height's slope
// magnifies a step by the picture's size. Only 8-bit pictures of several channels (colours, mostly)
// go up as 16-bit integers, half the memory. Wrap and filter are a Lookup, apart from the texels:
// one picture may be read in several ways.
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

// Textures and sampler objects in GPU memory.
//
// The levels of a MipChain are uploaded as 32-bit floats, so that filtered values equal the CPU's:
// drivers filter integer formats with the precision of the format, and the slope of a height
// multiplies a quantisation step by the image size. Only 8-bit images of several channels (mostly
// colors) are uploaded as 16-bit integers, half the memory; also if they were decoded from sRGB:
// a hardware sRGB format would round mips to 8 bits. A Sampler holds wrap and filter, separate from
// the texels: one texture may be sampled in several ways.
#pragma once

#include <cstdint>
#include <span>

#include "base/texture_options.h"
#include "gpu/gl_handle.h"
#include "image/mips.h"

namespace wrinkle::gpu {

class Texture {
public:
    static Texture upload(const MipChain& chain);  // an empty chain gives one black texel
    // 32-bit floats, four per texel, row by row from the bottom; one level, for texelFetch.
    static Texture of_floats(int width, int height, std::span<const float> rgba);

    void bind(int unit) const;
    uint32_t id() const { return handle_.id(); }

private:
    Texture();  // bound to unit 0
    TextureHandle handle_ = TextureHandle::make();
};

// Sampler object. linear: trilinear; nearest: the nearest texel of the nearest level.
class Sampler {
public:
    Sampler(Wrap wrap, Filter filter);
    void bind(int unit) const;

private:
    SamplerHandle handle_ = SamplerHandle::make();
};

}  // namespace wrinkle::gpu

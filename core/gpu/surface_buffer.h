// Textures for the values of a material per pixel (gpu/surface_values.h), with two depth textures
// for layers of transparent surfaces, nearest first (Everitt, "Interactive order-independent
// transparency", 2001).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/diagnostics.h"
#include "gpu/gl_handle.h"

namespace wrinkle::gpu {

class SurfaceBuffer {
public:
    // Returns std::nullopt and reports an error if the driver cannot draw into it.
    static std::optional<SurfaceBuffer> make(int width, int height, int texels,
                                             Diagnostics& diagnostics);

    bool fits(int width, int height, int texels) const;

    // Binds and clears the textures of a layer, counted from 0.
    void begin_layer(int layer) const;
    void bind_nearer(int unit, int layer) const;  // depth of the layer before, if there is one
    void bind_texels(int first_unit) const;

private:
    SurfaceBuffer() = default;
    bool build(int texels);

    int width_ = 0, height_ = 0;
    std::vector<TextureHandle> texels_;
    std::array<TextureHandle, 2> depths_{TextureHandle::make(), TextureHandle::make()};
    FramebufferHandle framebuffer_ = FramebufferHandle::make();
};

}  // namespace wrinkle::gpu

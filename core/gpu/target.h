// Render target: color textures of one size, with a depth buffer.
//
// Pixels are read from the bottom row upwards, as in `Image`. With several samples the pixels are
// in multisampled buffers until resolve() averages them into the color textures.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostics.h"
#include "gpu/gl_handle.h"
#include "image/image.h"

namespace wrinkle::gpu {

enum class PixelFormat : uint8_t { rgba8, rgba32f };

struct TargetOptions {
    int width = 512;
    int height = 512;
    PixelFormat format = PixelFormat::rgba8;
    int samples = 1;  // clamped to the driver's limit
    int colors = 1;   // 1 to 8; 1 with several samples
};

class Target {
public:
    // Returns std::nullopt and reports an error for a size below 1 or above the driver's limit, or
    // an incomplete framebuffer.
    static std::optional<Target> make(const TargetOptions& options, Diagnostics& diagnostics);

    void bind() const;           // as the draw framebuffer, with a viewport over all of it
    void bind_resolved() const;  // likewise, the destination of resolve()
    void resolve() const;        // call after drawing, before textures are sampled or read

    int width() const { return options_.width; }
    int height() const { return options_.height; }
    const TargetOptions& options() const { return options_; }
    uint32_t texture(int color = 0) const { return textures_[static_cast<size_t>(color)].id(); }

    // Returns four floats per pixel, in [0, 1] for an rgba8 target.
    std::vector<float> read(int color = 0) const;
    // Returns the pixels as an image with four channels. An image of an rgba8 target can be saved
    // as 8 bits without loss.
    Image read_image(int color = 0) const;

private:
    Target() = default;
    bool build();

    TargetOptions options_;
    std::vector<TextureHandle> textures_;
    std::vector<RenderbufferHandle> buffers_;  // depth and multisampled colors
    FramebufferHandle framebuffer_;            // with the textures attached
    FramebufferHandle sample_framebuffer_;     // none without multisampling
};

}  // namespace wrinkle::gpu

// Environment map drawn behind the mesh: an equirectangular image (gpu/environment.h) at its own
// resolution, infinitely far away. Belongs to one context.
#pragma once

#include <optional>

#include "gpu/program.h"
#include "gpu/texture.h"

namespace wrinkle::gpu {

struct Scene;

class Backdrop {
public:
    // `radiance` is the result of radiance_of().
    explicit Backdrop(const MipChain& radiance);

    // Fills the bound target and leaves its depth unchanged. The radiance is multiplied by the
    // scene's `environment` and passed through the display curve of the shaded view.
    void draw(const Scene& scene, float aspect) const;

private:
    Texture texture_;
    Sampler sampler_;
    std::optional<Program> program_;
};

}  // namespace wrinkle::gpu

// The picture of the surroundings behind what is drawn: equirectangular, as gpu/environment.h takes
// it, at its own resolution and infinitely far away. Belongs to one context.
#pragma once

#include <optional>

#include "gpu/camera.h"
#include "gpu/program.h"
#include "gpu/texture.h"

namespace wrinkle::gpu {

class Backdrop {
public:
    // `radiance` as radiance_of() gives it.
    explicit Backdrop(const MipChain& radiance);
    Backdrop(Backdrop&& other) noexcept;
    Backdrop& operator=(Backdrop&& other) noexcept;
    ~Backdrop();

    // Fills the target that is bound, its depth left alone. `factor` times the radiance goes
    // through the display curve of the shaded view.
    void draw(const OrbitCamera& camera, float aspect, float factor, float exposure) const;

private:
    Texture texture_;
    Lookup lookup_;
    std::optional<Program> program_;
    uint32_t array_ = 0;  // without attributes
};

}  // namespace wrinkle::gpu

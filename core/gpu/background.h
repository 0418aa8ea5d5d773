// Background of the shaded view. Belongs to one context.
#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "mesh/mesh.h"

namespace wrinkle::gpu {

struct Scene;

class Background {
public:
    // The environment map, linear radiance (radiance_of()), is drawn at its own resolution.
    void set_environment(const MipChain& radiance);

    // Fills the bound target by the scene's `behind` and leaves its depth unchanged. `object`
    // are the bounds of the mesh in world space, above the studio's floor.
    bool draw(const Scene& scene, float aspect, const Bounds& object, Diagnostics& diagnostics);

private:
    bool draw_environment(const Scene& scene, float aspect, Diagnostics& diagnostics);
    bool draw_studio(const Scene& scene, float aspect, const Bounds& object,
                     Diagnostics& diagnostics);

    struct Map {
        Texture texture;
        Sampler sampler;
    };
    std::optional<Map> map_;
    std::optional<Program> studio_, environment_;
};

}  // namespace wrinkle::gpu

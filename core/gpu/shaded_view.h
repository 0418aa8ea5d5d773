// The shaded view by deferred shading: the material's program writes its values per pixel
// (gpu/surface_values.h), then a program that does not depend on the material lights them, and a
// third one averages the samples of a pixel after the tone curve. A new material compiles only its
// own program; there is one lighting program per model of surface and lighting.
//
// Transparent surfaces are drawn in layers from the nearest one, at most `most_layers`; surfaces
// behind the last one are not seen.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "gpu/bands.h"
#include "gpu/environment.h"
#include "gpu/program.h"
#include "gpu/surface_buffer.h"
#include "gpu/surface_values.h"
#include "gpu/target.h"
#include "gpu/texture.h"

namespace wrinkle::gpu {

struct Scene;
struct ViewOptions;
enum class Lighting : uint8_t;

constexpr int most_layers = 6;

// The first pass, with all uniforms of its program set except those of the layer.
struct MaterialPass {
    const Program& program;
    SurfaceModel model;
    bool transparent;  // the material has the output `opacity`
    bool mirrored;     // as in ObjectSpace
    int free_unit;     // first texture unit that the material does not use
    std::function<void()> draw;
};

class ShadedView {
public:
    void set_environment(EnvironmentTexture texture) { environment_ = std::move(texture); }

    // Draws the mesh over the background that the target holds; raw values replace it. Errors: the
    // driver has no room for the buffers.
    bool draw(const MaterialPass& material, const Scene& scene, const ViewOptions& options,
              const Target& target, Diagnostics& diagnostics);

    double strips_took() const { return strips_took_; }  // milliseconds of the last drawing

private:
    struct Frame;  // shared by the passes of one drawing

    bool prepare(Frame& frame, Diagnostics& diagnostics);
    const Program* lighting_for(SurfaceModel model, Lighting lighting, Diagnostics& diagnostics);
    void draw_layers(const Frame& frame, const Band& band);
    void light_layer(const Frame& frame);
    void resolve(const Frame& frame, const Band& band);

    std::optional<SurfaceBuffer> surface_;
    std::optional<Target> radiance_;
    std::optional<EnvironmentTexture> environment_;
    std::optional<Texture> albedos_;
    std::optional<Sampler> linear_;
    std::map<std::pair<SurfaceModel, Lighting>, Program> lightings_;
    std::optional<Program> resolve_;
    double strips_took_ = 0;
};

}  // namespace wrinkle::gpu

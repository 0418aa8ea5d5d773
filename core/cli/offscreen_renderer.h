// Renders materials on a mesh for `wrinkle render` and `wrinkle test`.
#pragma once

#include <optional>
#include <string>

#include "cli/material_run.h"
#include "gpu/context.h"
#include "gpu/renderer.h"
#include "gpu/target.h"
#include "image/image.h"
#include "mesh/mesh.h"

namespace wrinkle::cli {

// Position of the eye around the mesh.
struct EyePosition {
    float yaw = 0, pitch = 0;  // degrees; 0, 0 looks along -z
    float distance = 1;        // as multiple of the distance that shows the entire mesh
};

struct RenderOptions {
    std::string mesh = "sphere";  // shape name or path (cli/meshes.h); determines the camera
    int width = 512;
    int height = 512;
    gpu::View view = gpu::View::shaded;
    std::string output;   // shown by View::output
    std::string against;  // reference output of the difference view
    gpu::Lighting lighting = gpu::Lighting::ggx;
    gpu::Phong phong;
    gpu::Mood mood = gpu::Mood::studio;
    Image environment;  // replaces the mood's, unless empty
    gpu::Behind behind = gpu::Behind::studio;
    gpu::Tone tone = gpu::Tone::neutral;
    float exposure = 0;              // EV: radiance is multiplied by 2^EV
    float turn = 0;                  // rotation of the environment around +y, degrees
    std::optional<EyePosition> eye;  // default: gpu::default_camera()
    bool displace = false;           // displaces the mesh by the output `displacement`
};

inline constexpr int max_rendered_side = 16384;  // pixels

// Parses Ka, Kd, Ks and shininess, such as "0.1,0.7,0.4,32". Returns false if a value is negative
// or not finite.
bool parse_phong(const std::string& text, gpu::Phong& phong);

// Parses yaw, pitch and optionally a distance above 0, such as "30,15,0.5".
std::optional<EyePosition> parse_camera(const std::string& text);

// Loads an environment map. Returns std::nullopt and reports an error if the image cannot be read
// or does not hold radiance (half or float values).
std::optional<Image> load_environment(const std::string& file, Diagnostics& diagnostics);

// Returns the mesh, subdivided finely enough to show the displacement and displaced by the run's
// output; std::nullopt and an error on failure. Precondition: the run was compiled with given
// differentials, and `textures` holds its images.
std::optional<Mesh> displaced_mesh(const Mesh& still, const MaterialRun& run,
                                   const TextureStore& textures, Diagnostics& diagnostics);

struct RenderedImage {
    Image image;
    gpu::AngleStatistics angles;  // only in the difference view
};

// Offscreen renderer: a GL context, a renderer and a render target.
class OffscreenRenderer {
public:
    // Returns std::nullopt and reports an error if GL is unavailable or the driver does not support
    // the size (exit_environment).
    static std::optional<OffscreenRenderer> make(const RenderOptions& options, const Mesh& mesh,
                                                 Diagnostics& diagnostics);

    // Replaces the mesh; the camera is unchanged.
    void show(const Mesh& mesh) { renderer_.set_mesh(mesh); }

    // Precondition: the shader is a result of emit_function(). Returns std::nullopt and reports an
    // error of the graph on failure (exit_input).
    std::optional<RenderedImage> draw(const Shader& shader, const TextureStore& textures,
                                      Diagnostics& diagnostics);

private:
    OffscreenRenderer(gpu::Context context, gpu::Target target, const RenderOptions& options,
                      const Mesh& mesh);
    bool can_compare(const Shader& shader, Diagnostics& diagnostics) const;
    bool set_material(const Shader& material, const TextureStore& textures,
                      Diagnostics& diagnostics);

    gpu::Context context_;  // destroyed last
    gpu::Target target_;
    gpu::Renderer renderer_;
    RenderOptions options_;
    gpu::Scene scene_;
};

}  // namespace wrinkle::cli

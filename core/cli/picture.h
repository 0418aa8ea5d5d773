// Materials drawn on a mesh, as `wrinkle render` shows them and `wrinkle test` compares them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/material_run.h"
#include "gpu/context.h"
#include "gpu/renderer.h"
#include "gpu/target.h"
#include "image/image.h"
#include "mesh/mesh.h"

namespace wrinkle::cli {

struct PictureOptions {
    std::string mesh = "sphere";  // as cli/meshes.h takes it; it frames the picture
    int width = 512;
    int height = 512;
    gpu::View view = gpu::View::shaded;
    std::string against;  // of the difference view
    gpu::Lighting lighting = gpu::Lighting::ggx;
    gpu::Phong phong;
    Image environment;      // empty: sky and ground
    bool backdrop = true;   // shows the environment's picture behind the mesh
    bool displace = false;  // moves the mesh by the output `displacement`
};

// "640x480"; nothing for a text that is no size of 1 to 16384.
bool parse_size(const std::string& text, int& width, int& height);
std::vector<std::string> view_names();
std::vector<std::string> lighting_names();

// "0.1,0.7,0.4,32": Ka, Kd, Ks and shininess, finite and not negative.
bool parse_phong(const std::string& text, gpu::Phong& phong);

// A picture of the surroundings; nothing with an error for one that holds no radiance.
std::optional<Image> load_environment(const std::string& file, Diagnostics& diagnostics);

// The mesh in triangles fine enough to show a displacement, moved by that of the run, which was
// compiled with given differentials and has its images in `textures`.
std::optional<Mesh> displaced_mesh(const Mesh& still, const MaterialRun& run,
                                   const TextureStore& textures, Diagnostics& diagnostics);

struct Picture {
    Image image;
    gpu::AngleStatistics angles;  // of the difference view
};

// A context, a renderer in it, and what is drawn into.
class Painter {
public:
    // Nothing where there is no GL or the size is beyond the driver: the environment's fault.
    static std::optional<Painter> make(const PictureOptions& options, const Mesh& mesh,
                                       Diagnostics& diagnostics);

    // In place of the mesh at hand; the camera stays.
    void show(const Mesh& mesh) { renderer_.set_mesh(mesh); }

    // The shader is that of emit_function(). What fails here is the graph's fault.
    std::optional<Picture> draw(const Shader& shader, const TextureStore& textures,
                                Diagnostics& diagnostics);

private:
    Painter(gpu::Context context, gpu::Target target, const PictureOptions& options,
            const Mesh& mesh);
    bool can_compare(const Shader& shader, Diagnostics& diagnostics) const;
    bool set_material(const gpu::Material& material, const TextureStore& textures,
                      Diagnostics& diagnostics);

    gpu::Context context_;  // goes last
    gpu::Target target_;
    gpu::Renderer renderer_;
    PictureOptions options_;
    gpu::Scene scene_;
};

}  // namespace wrinkle::cli

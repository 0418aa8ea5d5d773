// Draws one mesh with one material: the preview and `wrinkle render`.
//
// Set a mesh and a material, then draw into targets any number of times. Changing a uniform, the
// scene or the camera compiles nothing; each view of a material is compiled when first drawn. Equal
// input gives equal pixels on one driver.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/mat4x4.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "emit/emit.h"
#include "gpu/background.h"
#include "gpu/camera.h"
#include "gpu/display.h"
#include "gpu/mesh_buffers.h"
#include "gpu/object_space.h"
#include "gpu/program.h"
#include "gpu/shaded_view.h"
#include "gpu/studio.h"
#include "gpu/target.h"
#include "gpu/texture.h"
#include "image/image.h"
#include "image/texels.h"
#include "mesh/mesh.h"

namespace wrinkle::gpu {

// Each view has a value per pixel (`raw`) and a display color:
//
//   shaded      Linear radiance under an environment and one directional light: OpenPBR
//               (gpu/lighting_text.h) or Phong. Displayed with exposure and tone curve
//               (gpu/display.h), over the background.
//   normal      The resolved normal n, object space, unit. Displayed as 0.5 + 0.5 n.
//   gradient    g = n - n' / (n . n'), with normal n' and surface normal n. Displayed as
//               0.5 + 0.5 g.
//   height      The output `height`; an error if it is missing. Gray over height_range.
//   uv          (u, v, 0) of uv0. Displayed as its fraction.
//   difference  Angle in degrees between the normal and the un-bumped normal, or the output
//               `against`. Heat map: ten colors of cividis (Nunez, Anderton and Renslow 2018), in
//               equal steps from dark blue at 0 to yellow at heat_degrees and above.
//   wireframe   0 on triangles, 1 on their edges. Displayed as gray lit from the eye, with light
//               edges.
//   output      Any output, by ViewOptions::output. Displayed as itself: a color through the sRGB
//               curve, a number in gray from 0 to 1, a height as above, a vector v as 0.5 + 0.5 v.
//
// Alpha of raw values is 1 on the mesh and 0 elsewhere, in the shaded view the opacity; colors are
// opaque, with the background.
enum class View : uint8_t { shaded, normal, gradient, height, uv, difference, wireframe, output };

std::span<const std::string_view> view_names();  // in the order of the enumerators, less `output`
std::optional<View> view_named(std::string_view name);

// Lighting model of the shaded view.
enum class Lighting : uint8_t { ggx, phong };

std::span<const std::string_view> lighting_names();  // in the order of the enumerators

// Phong lighting (Phong 1975), per pixel:
//     color * (ambient + diffuse * n.l) + specular * (r.v)^shininess
// r is the direction to the light mirrored at n; dot products are clamped to 0, and the last term
// is 0 where n.l or r.v is 0. Reads only normal, color and emission of the material; emission is
// added.
struct Phong {
    float ambient = 0.1F;   // Ka
    float diffuse = 0.7F;   // Kd
    float specular = 0.4F;  // Ks
    float shininess = 32;
};

// Background of the shaded view: the color `background`, a paper backdrop with the
// mesh's shadow on a floor, or the environment.
enum class Behind : uint8_t { plain, studio, environment };

struct Scene {
    glm::mat4 object{1};  // object to world
    OrbitCamera camera;
    Lighting lighting = Lighting::ggx;
    glm::vec3 to_light{-0.5F, 0.7F, 0.6F};  // directional light: world space, any length
    float light = 0;                        // its irradiance of a surface facing it, over pi
    float environment = 1;                  // factor on the environment's radiance
    float environment_turn = 0;  // rotation of the environment around +y, radians; +z towards +x
    float exposure = 1;          // factor on the radiance
    Tone tone = Tone::neutral;
    Phong phong;
    Behind behind = Behind::plain;
    glm::vec4 background{0.16F, 0.16F, 0.17F, 1};  // display color
};

struct ViewOptions {
    View view = View::shaded;
    std::string output;             // shown by View::output
    std::string normal = "normal";  // output used as the normal
    std::string against;  // difference view: an output with a normal; "": the un-bumped surface
    float heat_degrees = 45;
    glm::vec2 height_range{0, 0};  // black to white; if equal, the visible range
    bool raw = false;              // writes the value; requires an rgba32f target, one sample
    int samples = 4;               // per pixel of the shaded view: 1 or 4
    // If above 0, draws in strips of about this duration, each finished before the next begins, so
    // that other contexts of the driver run in between. The pixels are the same.
    double strip_milliseconds = 0;
    std::function<void()> before_strip;  // may block; an empty function is not called
};

struct AngleStatistics {
    double mean_degrees = 0;  // over the pixels of the mesh
    double max_degrees = 0;
    uint64_t pixels = 0;
};

// Missing outputs have the values of base/standard_outputs.h; a missing normal is the surface
// normal, flipped towards the eye on back faces. The object matrix M acts outside the material:
// normals are multiplied by cof(M) times the sign of det(M); that sign also selects the front
// faces.
//
// Errors: the driver's log for a shader that it rejects (lines of the material's source have their
// own numbers, the renderer's begin at 100001), a missing output, an attribute that the material
// reads and the mesh lacks, an image that cannot be read, a singular M.
class Renderer {
public:
    void set_mesh(const Mesh& mesh) { mesh_.emplace(mesh); }

    // Replaces the studio as the environment of the shaded view.
    void set_environment(const Image& image);
    void set_mood(Mood mood);

    // Compiles the shaded view and uploads the images; on failure returns false and retains the
    // previous material. A material that differs only in samplers and uniforms compiles nothing.
    // Precondition: the shader has no problems, is in the function form and has differentials from
    // the screen. Uniforms get the values of the graph.
    bool set_material(const Shader& material, Diagnostics& diagnostics);
    // Sets a uniform of the current material; returns false if it has no such uniform of this size.
    bool set_uniform(std::string_view name, std::span<const float> value);
    uint64_t programs_linked() const { return linked_; }  // total number, by this renderer

    // Uploads texels under a name that samplers may use as their file; other files are read when a
    // material first uses them. forget_images() makes the next set_material() read those files
    // again.
    bool add_image(const TexelSource& source, const MipChain& chain, Diagnostics& diagnostics);
    void forget_images();

    // Clears the target, draws and resolves it.
    bool draw(const Scene& scene, const ViewOptions& options, const Target& target,
              Diagnostics& diagnostics);

    // Returns the milliseconds of the last drawing in strips, without compiling its program.
    double strips_took() const { return strips_took_; }

    // Returns statistics of the difference view, drawn at the given size; std::nullopt and an error
    // on failure.
    std::optional<AngleStatistics> measure(const Scene& scene, const std::string& against,
                                           int width, int height, Diagnostics& diagnostics);

private:
    struct ProgramKey {
        View view = View::shaded;
        std::string normal = "normal", against = {}, output = {};
        friend auto operator<=>(const ProgramKey&, const ProgramKey&) = default;
    };
    struct CachedTexture {
        Texture texture;
        uint64_t bytes;
        bool is_file;        // read by this renderer, which can read it again
        bool stale = false;  // drawn until the next set_material() reads it again
    };

    bool upload_stale_images(const std::vector<SamplerInfo>& needed, Diagnostics& diagnostics);
    bool upload(const TexelSource& source, const MipChain& chain, bool is_file,
                Diagnostics& diagnostics);
    const Program* program_for(const ViewOptions& options, Diagnostics& diagnostics);
    bool can_draw(Diagnostics& diagnostics) const;
    bool has_outputs(const ViewOptions& options, Diagnostics& diagnostics) const;
    void draw_mesh(const Program& program) const;
    bool draw_shaded(const Program& program, const Scene& scene, const ViewOptions& options,
                     const Target& target, const ObjectSpace& space, Diagnostics& diagnostics);
    void draw_values(const Program& program, const ViewOptions& options, const Target& target,
                     const ObjectSpace& space);
    glm::vec2 seen_range(const Scene& scene, ViewOptions options, const Target& target,
                         Diagnostics& diagnostics);

    std::optional<MeshBuffers> mesh_;
    std::optional<Shader> material_;
    std::vector<Sampler> samplers_;  // one per sampler of the material
    std::map<ProgramKey, Program> programs_;
    std::map<TexelSource, CachedTexture> images_;
    ShadedView shaded_;
    Background background_;
    uint64_t linked_ = 0;
    double strips_took_ = 0;
};

}  // namespace wrinkle::gpu

// Draws one mesh with one material: the preview and `wrinkle render`.
//
// Set a mesh and a material, then draw into a target as often as you like. Changing a uniform, the
// scene or the camera compiles nothing; each view of a material is compiled when first drawn. Equal
// input gives equal pixels on one driver.
//
// Each view has a value per pixel (`raw`) and a color that it is shown in:
//
//   shaded      Linear radiance under one directional light: GGX with an environment (sky and
//               ground, or a picture: gpu/environment.h), or Phong without one. Shown times
//               exposure, through the sRGB curve; a channel that exceeds 0.8 by x becomes
//               0.8 + 0.2 x / (x + 0.2) before it.
//   normal      The resolved normal n, object space, unit. Shown as 0.5 + 0.5 n.
//   gradient    g = n - n' / (n . n'), of normal n' and surface normal n. Shown as 0.5 + 0.5 g.
//   height      The output `height`; refused where there is none. Gray over height_range.
//   uv          (u, v, 0) of uv0. Shown as its fraction.
//   difference  Angle in degrees between the normal and the un-bumped one, or that of the output
//               `against`. Heat map: ten colors of cividis (Nunez, Anderton and Renslow 2018), even
//               steps from dark blue at 0 to yellow at heat_degrees and beyond.
//   wireframe   0 on triangles, 1 on their edges. Shown gray, lit from the eye, and light.
//
// Alpha of raw values is 1 on the mesh and 0 beside it; colors are opaque, with the background.
//
// Missing outputs: normal = the surface's (turned towards the eye on back faces), color 0.6,
// roughness 0.5, metalness 0, occlusion 1. The object matrix M acts outside the material: normals
// go through cof(M) times the sign of det(M), which also sets what a front face is.
//
// Errors name what is at fault: the driver's log for a text it refuses (lines of the material's
// text keep their numbers, the renderer's own begin at 100001), a missing output, an attribute that
// the material reads and the mesh lacks, an image that cannot be read, a singular M.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/mat4x4.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "gpu/camera.h"
#include "gpu/material.h"
#include "gpu/target.h"
#include "image/image.h"
#include "image/mips.h"
#include "mesh/mesh.h"

namespace wrinkle::gpu {

enum class View : uint8_t { shaded, normal, gradient, height, uv, difference, wireframe };

std::span<const std::string_view> view_names();  // in the order of the enumerators
std::optional<View> view_named(std::string_view name);

// What lights the shaded view.
enum class Lighting : uint8_t { ggx, phong };

std::span<const std::string_view> lighting_names();  // in the order of the enumerators

// The light of classic texts (Phong 1975), per pixel:
//     color * (ambient + diffuse * n.l) + specular * (r.v)^shininess
// r is the direction to the light mirrored at n; the last term is absent where n.l is 0. Of a
// material it reads normal and color alone.
struct Phong {
    float ambient = 0.1F;   // Ka
    float diffuse = 0.7F;   // Kd
    float specular = 0.4F;  // Ks
    float shininess = 32;
};

struct Scene {
    glm::mat4 object{1};  // object to world
    OrbitCamera camera;
    glm::vec3 to_light{-0.5F, 0.7F, 0.6F};  // world space, any length
    float light = 0.85F;                    // irradiance of a surface that faces it, over pi
    float environment = 1;                  // factor on sky and ground
    float environment_turn = 0;             // of a picture round +y, radians; from +z towards +x
    float exposure = 1;
    Phong phong;
    bool surroundings = false;  // the picture of set_environment() behind the shaded view
    glm::vec4 background{0.16F, 0.16F, 0.17F, 1};  // as displayed
};

struct ViewOptions {
    View view = View::shaded;
    std::string normal = "normal";  // the output that is taken for the normal
    std::string against;  // for difference: an output with a normal; "" is the un-bumped surface
    float heat_degrees = 45;
    glm::vec2 height_range{0, 0};  // black to white; two equal values: the range that is seen
    bool raw = false;              // the value itself; wants an rgba32f target with one sample
    // Above 0: drawn in strips that take about this long, each done before the next begins, so that
    // others who share the driver get a turn between them. The pixels are the same.
    double strip_milliseconds = 0;
    std::function<void()> before_strip;  // may wait until others are done; empty: nothing
};

struct AngleStatistics {
    double mean_degrees = 0;  // over the pixels of the mesh
    double max_degrees = 0;
    uint64_t pixels = 0;
};

class Renderer {
public:
    Renderer();
    Renderer(Renderer&& other) noexcept;
    Renderer& operator=(Renderer&& other) noexcept;
    ~Renderer();

    void set_mesh(const Mesh& mesh);

    // How the shaded view is lit; takes effect with the next set_material. Compiles nothing.
    void set_lighting(Lighting lighting);
    void set_environment(const Image& picture);
    void forget_environment();  // sky and ground again

    // Compiles the shaded view and brings up the images; on failure the former material stays. A
    // material that differs in samplers and uniforms only compiles nothing.
    bool set_material(const Material& material, Diagnostics& diagnostics);
    // A value of the material in use; false when it has no such uniform.
    bool set_uniform(std::string_view name, std::span<const float> value);
    uint64_t programs_linked() const;  // ever, by this renderer

    // Keeps pixels under a name that samplers may give as their file; other files are read when a
    // material first needs them. forget_images() makes the next set_material read those anew.
    bool add_image(const std::string& file, const MipChain& chain, Diagnostics& diagnostics);
    void forget_images();

    // Clears the target, draws and resolves it.
    bool draw(const Scene& scene, const ViewOptions& options, const Target& target,
              Diagnostics& diagnostics);

    // How long the last drawing in strips took, the making of its program apart.
    double strips_took() const;

    // The difference view in numbers, at the given size.
    std::optional<AngleStatistics> measure(const Scene& scene, const std::string& against,
                                           int width, int height, Diagnostics& diagnostics);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace wrinkle::gpu

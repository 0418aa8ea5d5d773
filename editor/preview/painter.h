// Draws what a job asks for into textures. Wants its GL context current on every call, its end
// included; the thread of preview.h owns one.
//
// The last good picture stays: a material that the driver refuses, an image or a mesh that cannot
// be read, a view that the graph cannot give leave its textures as they were and say why. It goes
// when another graph is opened.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/preview/displacement.h"
#include "editor/preview/still.h"
#include "editor/preview/view.h"
#include "gpu/renderer.h"

namespace wrinkle::editor {

struct PreviewJob {
    uint64_t version = 0;
    uint64_t graph = 0;  // when it changes, what is drawn so far is another graph's
    std::shared_ptr<const gpu::Material> material;     // nullptr: none yet
    std::map<std::string, std::vector<float>> values;  // of its uniforms, where they have changed
    std::shared_ptr<const Displacement> displacement;  // nullptr: none
    PreviewView view;
    std::string against;  // the output that is the other normal; "" compares nothing
    bool difference = false;
    float degrees = 0;  // at the end of the scale; 0 finds it
    int width = 0, height = 0;
    // When one of them changes, its files are read again.
    uint64_t images = 0, meshes = 0, lights = 0;
    std::shared_ptr<Still> still;  // answered after the picture, once
};

// Angles between the two normals, over the pixels of the mesh.
struct AngleFigures {
    float mean = 0, max = 0;
    float end = 0;  // of the heat map's scale: 3, 12, 45 or 180, or as asked
    std::shared_ptr<const std::vector<float>> degrees;  // by pixel, bottom row first; < 0 beside it
};

struct PreviewPicture {
    uint64_t version = 0;             // of the job that it answers
    uint64_t graph = 0;               // of that job
    uint32_t texture = 0, other = 0;  // side A and B, bottom row first; 0: there is none
    int slot = -1;                    // which textures they are
    int width = 0, height = 0;
    bool refused = false;      // the material, so the picture is of a former one
    bool lost = false;         // the driver dropped the context: all has to be made anew
    std::string double_sided;  // the mesh, if one of its materials is
    Diagnostics problems;
    AngleFigures angles;
    double milliseconds = 0;  // of the drawing, until its last pixel
    bool first = false;       // of a program or a mesh: the time has its making in it
    uint64_t programs = 0;    // linked so far
};

// What `job.still` asks for, from what the renderer holds; nothing, with the reason.
std::optional<Image> still_picture(gpu::Renderer& renderer, gpu::Scene scene, const PreviewJob& job,
                                   float heat_degrees, Diagnostics& problems);

class PreviewPainter {
public:
    // before_strip is called between the strips of a picture that takes long; it may wait.
    explicit PreviewPainter(std::function<void()> before_strip = {})
        : before_strip_(std::move(before_strip)) {}

    // Textures of slot `held` are being looked at and stay as they are.
    PreviewPicture draw(const PreviewJob& job, int held);

private:
    struct Slot {
        std::optional<gpu::Target> a, b;
    };
    void begin_graph(uint64_t graph);
    bool use_material(const PreviewJob& job);
    bool use_mesh(const PreviewJob& job, Diagnostics& problems);
    void use_light(const PreviewJob& job);
    bool draw_sides(const PreviewJob& job, PreviewPicture& picture);
    void draw_still(const PreviewJob& job);
    bool measure(const PreviewJob& job, const gpu::Scene& scene, PreviewPicture& picture);
    gpu::Scene scene_of(const PreviewView& view) const;
    gpu::ViewOptions patient() const;

    std::function<void()> before_strip_;
    gpu::Renderer renderer_;
    std::array<Slot, 3> slots_;
    std::optional<gpu::Target> numbers_;
    gpu::OrbitCamera framing_;
    PreviewPicture last_;
    std::shared_ptr<const gpu::Material> tried_;
    Diagnostics refusal_;  // of `tried_`
    Diagnostics dark_;     // of the environment
    bool has_material_ = false, relit_ = false;
    bool slow_ = true;  // the next picture may be
    uint64_t images_ = 0, graph_ = 0;
    // What the renderer has of the job.
    uint64_t mesh_read_ = 0, mesh_images_ = 0, light_read_ = 0;
    std::string mesh_, environment_;
    bool double_sided_ = false;  // one of the materials of mesh_ is
    float scale_ = 0;
    std::shared_ptr<const Displacement> displacement_;
    TextureStore textures_;  // of the displacement
    gpu::Lighting lighting_ = gpu::Lighting::ggx;
};

}  // namespace wrinkle::editor

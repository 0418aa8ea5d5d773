// Draws a preview job into textures. Its GL context must be current on every call, including the
// destructor; the thread of preview.h owns one.
//
// The last good rendering is retained: if the driver rejects a material, an image or a mesh cannot
// be read, or the graph has no such view, the textures do not change and the result has the reason.
// It is discarded when another graph is opened.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/model/document/displacement.h"
#include "editor/view/preview/image_request.h"
#include "gpu/renderer.h"

namespace wrinkle::editor {

// View settings of the preview: plain values, never saved in the graph.
struct PreviewView {
    std::string mesh = "sphere";  // a shape's name, or the path of an OBJ or glTF file
    gpu::Mood mood = gpu::Mood::studio;
    std::string environment;  // path of an .hdr or .exr, which replaces the mood's; may be ""
    gpu::View view = gpu::View::shaded;
    gpu::Lighting lighting = gpu::Lighting::ggx;
    float yaw = 0.5F, pitch = 0.25F;  // eye direction, radians
    float distance = 1;               // as multiple of the distance that shows the entire mesh
    float pan_x = 0, pan_y = 0;       // shift of the target, in units of that distance
    float turn = 0;                   // rotation of the light around +y, radians
    float light_pitch = 0.66F;        // elevation of the directional light, radians
    float scale = 1;                  // scale of the mesh's coordinates: heights keep their length
    bool displaced = false;           // by the output `displacement`
    bool operator==(const PreviewView&) const = default;
};

// Comparison of the material with another normal, side by side, or the angle between the two.
struct CompareView {
    enum class Mode : uint8_t { off, split, flip };
    Mode mode = Mode::off;
    bool difference = false;  // side B shows degrees, else the other normal
    float degrees = 0;        // end of the heat map's scale; 0: automatic
    float split = 0.5F;       // fraction of the width
    bool flipped = false;     // side B is shown
    bool operator==(const CompareView&) const = default;
};

// View, comparison and size of a rendering.
struct PreviewFrame {
    PreviewView view;
    std::string against;  // output with the other normal; "" compares nothing
    bool difference = false;
    float degrees = 0;  // end of the heat map's scale; 0: automatic
    int width = 0, height = 0;
    bool operator==(const PreviewFrame&) const = default;
};

struct PreviewJob : PreviewFrame {
    uint64_t version = 0;
    uint64_t graph = 0;                                // a change discards the last rendering
    std::shared_ptr<const Shader> material;            // nullptr: none yet
    std::map<std::string, std::vector<float>> values;  // uniform values changed since `material`
    std::shared_ptr<const Displacement> displacement;  // nullptr: none
    // If one of them changes, its files are read again.
    uint64_t images = 0, meshes = 0, lights = 0;
    std::shared_ptr<ImageRequest> image_request;  // answered once, after the preview
    bool smooth = false;                          // 4 samples per pixel, however long they take
};

// Angles between the two normals, over the pixels of the mesh.
struct AngleFigures {
    float mean = 0, max = 0;
    float end = 0;  // end of the heat map's scale: 3, 12, 45 or 180, or as requested
    std::shared_ptr<const std::vector<float>> degrees;  // by pixel, bottom row first; < 0 outside
};

struct PreviewImage {
    uint64_t version = 0;             // version of the drawn job
    uint64_t graph = 0;               // graph of that job
    uint32_t texture = 0, other = 0;  // sides A and B, bottom row first; 0: absent
    int slot = -1;                    // index of the textures
    int width = 0, height = 0;
    bool smooth = false;       // drawn with 4 samples per pixel
    bool refused = false;      // the driver rejected the material; an earlier one is shown
    bool lost = false;         // the driver lost the context: recreate all GL objects
    std::string double_sided;  // the mesh if one of its materials is double-sided
    Diagnostics problems;
    AngleFigures angles;
    double milliseconds = 0;  // drawing time, including GPU work
    bool first = false;       // first use of a program or a mesh: includes its setup time
    uint64_t programs = 0;    // linked so far
};

class PreviewPainter {
public:
    // before_strip is called between the strips of a slow rendering; it may wait.
    explicit PreviewPainter(std::function<void()> before_strip = {})
        : before_strip_(std::move(before_strip)) {}

    // Does not write the textures of slot `held`, which are on screen.
    PreviewImage draw(const PreviewJob& job, int held);

private:
    // Inputs of the drawn mesh.
    struct MeshKey {
        std::string mesh;
        float scale = 0;
        std::shared_ptr<const Displacement> displacement;
        uint64_t meshes = 0, images = 0;  // changes of the job; `images` 0 without displacement
        bool operator==(const MeshKey&) const = default;
    };
    struct Slot {
        std::optional<gpu::Target> a, b;
    };
    void begin_graph(uint64_t graph);
    bool use_material(const PreviewJob& job);
    bool use_mesh(const PreviewJob& job, Diagnostics& problems);
    void use_light(const PreviewJob& job);
    bool draw_sides(const PreviewJob& job, gpu::ViewOptions view, PreviewImage& image);
    void draw_image_request(const PreviewJob& job);
    bool measure(const PreviewJob& job, const gpu::Scene& scene, PreviewImage& image);
    gpu::Scene scene_of(const PreviewView& view) const;
    gpu::ViewOptions options_of(const PreviewJob& job) const;

    std::function<void()> before_strip_;
    gpu::Renderer renderer_;
    std::array<Slot, 3> slots_;
    std::optional<gpu::Target> numbers_;
    gpu::OrbitCamera framing_;
    PreviewImage last_;
    std::shared_ptr<const Shader> tried_;
    Diagnostics refusal_;  // errors of `tried_`
    Diagnostics dark_;     // problems of the environment
    bool has_material_ = false;
    std::optional<double> sample_took_;  // milliseconds per sample of a pixel, of the last drawing
    uint64_t images_ = 0, graph_ = 0;
    // State of the renderer, as read from jobs.
    uint64_t light_read_ = 0;
    MeshKey mesh_;
    std::string environment_;
    gpu::Mood mood_ = gpu::Mood::studio;
    bool double_sided_ = false;  // one of the materials of mesh_ is double-sided
    TextureStore textures_;      // textures of the displacement
};

}  // namespace wrinkle::editor

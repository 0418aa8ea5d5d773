#include "cli/offscreen_renderer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <span>

#include "bake/displace.h"
#include "base/diagnostics.h"
#include "cli/arguments.h"
#include "cli/evaluation.h"
#include "cli/progress.h"
#include "image/load.h"
#include "mesh/mesh.h"

namespace wrinkle::cli {

std::optional<Mesh> displaced_mesh(const Mesh& still, const MaterialRun& run,
                                   const TextureStore& textures, Diagnostics& diagnostics) {
    constexpr float triangles_across = 300;
    Module module = run.compiled.module;
    std::erase_if(module.outputs, [](const ModuleOutput& o) { return o.name != "displacement"; });
    if (module.outputs.empty()) {
        diagnostics.error(RuleId::unknown_output, "the graph has no output 'displacement'",
                          "a height in length units of object space");
        return {};
    }
    const Bounds bounds = bounds_of(still);
    Mesh mesh = subdivided(still, glm::distance(bounds.low, bounds.high) / triangles_across);
    std::string why;
    const Program program = compile_program(module, why);
    if (why.empty()) why = displace(mesh, program, 0, textures.textures_of(module.resources));
    if (why.empty()) return mesh;
    diagnostics.error(RuleId::over_limit, why);
    return {};
}

bool parse_phong(const std::string& text, gpu::Phong& phong) {
    float values[4];
    if (!parse_numbers<float>(text, ',', values)) return false;
    for (const float value : values)
        if (!std::isfinite(value) || value < 0) return false;
    phong = {values[0], values[1], values[2], values[3]};
    return true;
}

std::optional<EyePosition> parse_camera(const std::string& text) {
    float values[3] = {0, 0, 1};
    const bool far = std::count(text.begin(), text.end(), ',') == 2;
    if (!parse_numbers<float>(text, ',', std::span(values).first(far ? 3 : 2))) return {};
    const bool finite = std::isfinite(values[0]) && std::isfinite(values[1]);
    if (!finite || !(values[2] > 0) || !std::isfinite(values[2])) return {};
    return EyePosition{values[0], values[1], values[2]};
}

std::optional<Image> load_environment(const std::string& file, Diagnostics& diagnostics) {
    auto image = load_image(file, diagnostics);
    if (!image || image->source == PixelType::half || image->source == PixelType::float32)
        return image;
    diagnostics.add(
        file_problem(Severity::error, RuleId::image_values, file,
                     "holds " + std::string(name_of(image->source)) + " values, no radiance",
                     "an equirectangular .hdr or .exr"));
    return {};
}

// A mood is lit from behind the default camera, wherever `--camera` looks from.
static gpu::Scene scene_of(const RenderOptions& options, const gpu::OrbitCamera& camera) {
    gpu::Scene scene;
    scene.camera = camera;
    if (const auto& eye = options.eye) {
        scene.camera.yaw = glm::radians(eye->yaw);
        scene.camera.pitch = glm::radians(eye->pitch);
        scene.camera.distance *= eye->distance;
    }
    const float behind_camera = options.environment.empty() ? camera.yaw : 0;
    scene.environment_turn = behind_camera + glm::radians(options.turn);
    scene.lighting = options.lighting;
    scene.phong = options.phong;
    scene.to_light = gpu::light_direction(scene.environment_turn);
    scene.light = options.environment.empty() ? gpu::directional_light_of(options.mood) : 0;
    scene.exposure = std::exp2(options.exposure);
    scene.tone = options.tone;
    scene.behind = options.behind;
    return scene;
}

std::optional<OffscreenRenderer> OffscreenRenderer::make(const RenderOptions& options,
                                                         const Mesh& mesh,
                                                         Diagnostics& diagnostics) {
    auto context = gpu::Context::offscreen(diagnostics);
    if (!context) return {};
    if (!context->make_current()) {
        diagnostics.error(RuleId::opengl, "the OpenGL context cannot be made current");
        return {};
    }
    gpu::TargetOptions wanted;
    wanted.width = options.width;
    wanted.height = options.height;
    auto target = gpu::Target::make(wanted, diagnostics);
    if (!target) return {};
    return OffscreenRenderer(std::move(*context), std::move(*target), options, mesh);
}

OffscreenRenderer::OffscreenRenderer(gpu::Context context, gpu::Target target,
                                     const RenderOptions& options, const Mesh& mesh)
    : context_(std::move(context)), target_(std::move(target)), options_(options) {
    renderer_.set_mesh(mesh);
    if (!options.environment.empty())
        renderer_.set_environment(options.environment);
    else if (options.mood != gpu::Mood::studio || options.behind == gpu::Behind::environment)
        renderer_.set_mood(options.mood);
    options_.environment = {};  // the renderer holds it
    scene_ = scene_of(options, gpu::default_camera(mesh, options.mesh));
}

// Returns false and reports an error if the reference output of the difference view is not a
// normal.
bool OffscreenRenderer::can_compare(const Shader& shader, Diagnostics& diagnostics) const {
    if (options_.view != gpu::View::difference) return true;
    for (const OutputInfo& output : shader.reflection.outputs) {
        const auto type = static_cast<PortType>(output.port_type);
        if (output.output != options_.against || type == PortType::normal_ ||
            type == PortType::vec3_)
            continue;
        diagnostics.error(RuleId::type_mismatch,
                          "the output '" + options_.against + "' holds a " +
                              std::string(name_of(type)) + ", which is not a normal",
                          type == PortType::gradient_ || type == PortType::derivative_
                              ? "put a node 'resolve' before it"
                              : "an output that holds a normal");
        return false;
    }
    return true;
}

bool OffscreenRenderer::set_material(const Shader& material, const TextureStore& textures,
                                     Diagnostics& diagnostics) {
    for (const SamplerInfo& sampler : material.reflection.samplers) {
        const TexelSource source = texels_of(sampler);
        const auto chain = textures.find(source);
        if (!chain || !renderer_.add_image(source, *chain, diagnostics)) return false;
    }
    return renderer_.set_material(material, diagnostics);
}

std::optional<RenderedImage> OffscreenRenderer::draw(const Shader& shader,
                                                     const TextureStore& textures,
                                                     Diagnostics& diagnostics) {
    if (!can_compare(shader, diagnostics)) return {};
    const SlowStep step("compiling and drawing the shader");
    if (!set_material(shader, textures, diagnostics)) return {};
    gpu::ViewOptions view;
    view.view = options_.view;
    view.output = options_.output;
    view.against = options_.against;
    if (!renderer_.draw(scene_, view, target_, diagnostics)) return {};
    RenderedImage rendered{target_.read_image(), {}};
    if (options_.view != gpu::View::difference) return rendered;
    const auto angles =
        renderer_.measure(scene_, options_.against, options_.width, options_.height, diagnostics);
    if (!angles) return {};
    rendered.angles = *angles;
    return rendered;
}

}  // namespace wrinkle::cli

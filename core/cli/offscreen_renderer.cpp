#include "cli/offscreen_renderer.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "bake/displace.h"
#include "base/diagnostics.h"
#include "cli/arguments.h"
#include "cli/evaluation.h"
#include "cli/progress.h"
#include "image/load.h"
#include "mesh/mesh.h"

namespace wrinkle::cli {

bool parse_size(const std::string& text, int& width, int& height) {
    constexpr int max_side = 16384;
    int sides[2];
    if (!parse_numbers<int>(text, 'x', sides)) return false;
    width = sides[0];
    height = sides[1];
    return width >= 1 && width <= max_side && height >= 1 && height <= max_side;
}

std::optional<Mesh> displaced_mesh(const Mesh& still, const MaterialRun& run,
                                   const TextureStore& textures, Diagnostics& diagnostics) {
    constexpr float triangles_across = 300;
    Module module = run.compiled.module;
    std::erase_if(module.outputs, [](const ModuleOutput& o) { return o.name != "displacement"; });
    if (module.outputs.empty()) {
        diagnostics.error("the graph has no output 'displacement'",
                          "a height in length units of object space");
        return {};
    }
    const Bounds bounds = bounds_of(still);
    Mesh mesh = subdivided(still, glm::distance(bounds.low, bounds.high) / triangles_across);
    std::string why;
    const Program program = compile_program(module, why);
    if (why.empty()) why = displace(mesh, program, 0, textures.textures_of(module.resources));
    if (why.empty()) return mesh;
    diagnostics.error(why);
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

std::optional<Image> load_environment(const std::string& file, Diagnostics& diagnostics) {
    auto image = load_image(file, diagnostics);
    if (!image || image->source == PixelType::half || image->source == PixelType::float32)
        return image;
    diagnostics.add(
        file_problem(Severity::error, file,
                     "holds " + std::string(name_of(image->source)) + " values, no radiance",
                     "an equirectangular .hdr or .exr"));
    return {};
}

std::optional<OffscreenRenderer> OffscreenRenderer::make(const RenderOptions& options,
                                                         const Mesh& mesh,
                                                         Diagnostics& diagnostics) {
    auto context = gpu::Context::offscreen(diagnostics);
    if (!context) return {};
    if (!context->make_current()) {
        diagnostics.error("the OpenGL context cannot be made current");
        return {};
    }
    gpu::TargetOptions wanted;
    wanted.width = options.width;
    wanted.height = options.height;
    wanted.samples = options.view == gpu::View::shaded ? 4 : 1;  // do not average values
    auto target = gpu::Target::make(wanted, diagnostics);
    if (!target) return {};
    return OffscreenRenderer(std::move(*context), std::move(*target), options, mesh);
}

OffscreenRenderer::OffscreenRenderer(gpu::Context context, gpu::Target target,
                                     const RenderOptions& options, const Mesh& mesh)
    : context_(std::move(context)), target_(std::move(target)), options_(options) {
    renderer_.set_mesh(mesh);
    renderer_.set_lighting(options.lighting);
    if (!options.environment.empty()) renderer_.set_environment(options.environment);
    scene_.surroundings = options.backdrop;
    scene_.phong = options.phong;
    options_.environment = {};  // the renderer holds it
    scene_.camera = gpu::default_camera(mesh, options.mesh);
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
        diagnostics.error("the output '" + options_.against + "' holds a " +
                              std::string(name_of(type)) + ", which is no normal to compare with",
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

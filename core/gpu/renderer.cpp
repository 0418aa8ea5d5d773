#include "gpu/renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "glsl/attributes.h"
#include "glsl/emit.h"
#include "glsl/log.h"
#include "gpu/backdrop.h"
#include "gpu/draw_state.h"
#include "gpu/environment.h"
#include "gpu/mesh_buffers.h"
#include "gpu/object_space.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "gpu/wrapper.h"
#include "image/load.h"

namespace wrinkle::gpu {
namespace {

std::string in_quotes(std::string_view text) {
    return "'" + std::string(text) + "'";
}

// Returns the same material with another output as its normal.
Shader with_normal(Shader material, const FunctionInfo& normal) {
    auto& functions = material.reflection.functions;
    FunctionInfo renamed = normal;
    renamed.output = "normal";
    std::erase_if(functions, [](const FunctionInfo& f) { return f.output == "normal"; });
    functions.push_back(std::move(renamed));
    return material;
}

// The compiled shader numbers the lines of the material's source from 1 (wrapper.h).
Diagnostic refusal(const Reflection& reflection, const std::string& log) {
    Diagnostic problem;
    problem.message = "the driver refuses the material's shader: " + log;
    const uint32_t node = node_of_line(reflection, line_in(log));
    if (node != no_node) problem.node = reflection.node_paths[node];
    return problem;
}

std::optional<Program> compile(const Shader& material, View view, const FunctionInfo* against,
                               const Shading& shading, Diagnostics& diagnostics) {
    const ShaderText text = wrap_material(material, view, against, shading);
    const std::array<std::string, 1> outputs{"WrView_color"};
    std::string log;
    std::optional<Program> program = Program::link(text.vertex, text.fragment, outputs, log);
    if (!program) diagnostics.add(refusal(material.reflection, log));
    return program;
}

bool check_members(const Shader& material, Diagnostics& diagnostics) {
    for (const MemberInfo& member : material.reflection.members)
        if (member.variant != Variant::value) {
            diagnostics.error("the material reads " + in_quotes(member.name) +
                              ", which is no property of a drawn surface");
            return false;
        }
    return true;
}

}  // namespace

struct CachedTexture {
    Texture texture;
    uint64_t bytes;
    bool is_file;        // read by this renderer, which can read it again
    bool stale = false;  // drawn until the next set_material() reads it again
};

struct Renderer::State {
    struct ProgramKey {
        View view = View::shaded;
        std::string normal = "normal", against = {};
        friend auto operator<=>(const ProgramKey&, const ProgramKey&) = default;
    };
    std::optional<MeshBuffers> mesh;
    std::optional<Shader> material;
    std::vector<Sampler> samplers;  // one per sampler of the material
    std::map<ProgramKey, Program> programs;
    std::map<std::string, CachedTexture> images;
    std::optional<EnvironmentTexture> environment;
    std::optional<Backdrop> backdrop;
    Shading wanted, shading;  // for the next material; of the current one
    uint64_t linked = 0;
    double strips_took = 0;

    bool upload_stale_images(const std::vector<SamplerInfo>& needed, Diagnostics& diagnostics);
    bool upload(const std::string& file, const MipChain& chain, bool is_file,
                Diagnostics& diagnostics);
    const Program* program_for(const ViewOptions& options, Diagnostics& diagnostics);
    bool can_draw(Diagnostics& diagnostics) const;
    void draw_mesh(const Program& program) const;
    void draw_strips(const Program& program, const Target& target, const ViewOptions& options);
};

bool Renderer::State::upload(const std::string& file, const MipChain& chain, bool is_file,
                             Diagnostics& diagnostics) {
    if (chain.levels.empty()) {
        diagnostics.error("image " + in_quotes(file) + " has no texels");
        return false;
    }
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    const Image& image = chain.levels.front();
    if (std::max(image.width, image.height) > static_cast<uint32_t>(limit)) {
        diagnostics.error("image " + in_quotes(file) + " is larger than this driver can draw",
                          "at most " + std::to_string(limit) + " texels a side");
        return false;
    }
    images.insert_or_assign(
        file, CachedTexture{Texture::upload(chain), bytes_with_mips(chain.levels[0]), is_file});
    return true;
}

bool Renderer::State::upload_stale_images(const std::vector<SamplerInfo>& needed,
                                          Diagnostics& diagnostics) {
    GLint units = 0;
    glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    if (wanted.environment) --units;
    if (needed.size() > static_cast<size_t>(units)) {
        diagnostics.error("the material reads " + std::to_string(needed.size()) +
                              " textures, more than this driver binds at once",
                          "at most " + std::to_string(units));
        return false;
    }
    bool ok = true;
    ImageLimits limits = image_limits_from_environment(diagnostics);
    limits.left_bytes = limit_of(Limit::all_images_bytes);
    for (const SamplerInfo& sampler : needed) {
        const auto cached = images.find(sampler.file);
        if (cached == images.end() || cached->second.stale) {
            std::optional<Image> image = load_image(sampler.file, limits, diagnostics);
            ok = image && upload(sampler.file, build_mips(std::move(*image)), true, diagnostics) &&
                 ok;
        }
        if (const auto now = images.find(sampler.file); now != images.end())
            limits.left_bytes -= std::min(limits.left_bytes, now->second.bytes);
    }
    return ok;
}

const Program* Renderer::State::program_for(const ViewOptions& options, Diagnostics& diagnostics) {
    const std::string against = options.view == View::difference ? options.against : "";
    const ProgramKey key{options.view, options.normal, against};
    if (const auto found = programs.find(key); found != programs.end()) return &found->second;
    const FunctionInfo* other = find_output(*material, against);
    const FunctionInfo* normal = find_output(*material, options.normal);
    for (const std::string& name : {against, options.normal})
        if (!name.empty() && name != "normal" && !find_output(*material, name)) {
            diagnostics.error("the graph has no output " + in_quotes(name) + " to compare with");
            return nullptr;
        }
    if (options.view == View::height && !find_output(*material, "height")) {
        diagnostics.error("the graph has no output 'height' to show", "an output named 'height'");
        return nullptr;
    }
    const bool usual = !normal || options.normal == "normal";
    std::optional<Program> program = compile(usual ? *material : with_normal(*material, *normal),
                                             options.view, other, shading, diagnostics);
    if (!program) return nullptr;
    ++linked;
    return &programs.emplace(key, std::move(*program)).first->second;
}

bool Renderer::State::can_draw(Diagnostics& diagnostics) const {
    if (!mesh || !material) {
        diagnostics.error("there is nothing to draw: a mesh and a material are needed");
        return false;
    }
    bool ok = true;
    for (const MemberInfo& member : material->reflection.members) {
        const int location = location_of(member.input);
        if (location < 0 || mesh->has(location)) continue;
        diagnostics.error("the material reads " + in_quotes(info(member.input).name) +
                              ", which the mesh does not have",
                          "a mesh that has it, or a graph that reads another one");
        ok = false;
    }
    return ok;
}

void Renderer::State::draw_mesh(const Program& program) const {
    for (size_t i = 0; i < samplers.size(); ++i) {
        const SamplerInfo& sampler = material->reflection.samplers[i];
        images.at(sampler.file).texture.bind(static_cast<int>(i));
        samplers[i].bind(static_cast<int>(i));
        program.set(sampler.name.c_str(), static_cast<int>(i));
    }
    for (const UniformInfo& uniform : material->reflection.uniforms)
        program.set(uniform);
    if (shading.environment) {
        const auto unit = static_cast<int>(samplers.size());
        environment->bind(unit);
        program.set("WrView_surroundings", unit);
    }
    mesh->draw();
    for (size_t i = 0; i < samplers.size(); ++i)
        glBindSampler(static_cast<GLuint>(i), 0);  // so that other drawing is not affected
}

// Draws strips from the bottom. The first height is a guess; each duration sets the next height.
void Renderer::State::draw_strips(const Program& program, const Target& target,
                                  const ViewOptions& options) {
    const double milliseconds = options.strip_milliseconds;
    if (milliseconds <= 0) return draw_mesh(program);
    const int height = target.height();
    glEnable(GL_SCISSOR_TEST);
    strips_took = 0;
    for (int low = 0, rows = std::max(height / 8, 1); low < height;) {
        if (options.before_strip) options.before_strip();
        glScissor(0, low, target.width(), rows);
        draw_mesh(program);
        const auto start = std::chrono::steady_clock::now();
        glFinish();
        const std::chrono::duration<double, std::milli> took =
            std::chrono::steady_clock::now() - start;
        strips_took += took.count();
        low += rows;
        const double fit = milliseconds / std::max(took.count(), milliseconds / 4);
        rows = std::max(static_cast<int>(rows * fit), 1);
    }
    glDisable(GL_SCISSOR_TEST);
}

Renderer::Renderer() : state_(std::make_unique<State>()) {}
Renderer::Renderer(Renderer&& other) noexcept = default;
Renderer& Renderer::operator=(Renderer&& other) noexcept = default;
Renderer::~Renderer() = default;

void Renderer::set_mesh(const Mesh& mesh) {
    state_->mesh.emplace(mesh);
}

void Renderer::set_lighting(Lighting lighting) {
    state_->wanted.lighting = lighting;
}

void Renderer::set_environment(const Image& image) {
    state_->environment.emplace(prefilter(image));
    state_->backdrop.emplace(radiance_of(image));
    state_->wanted.environment = true;
}

void Renderer::forget_environment() {
    state_->wanted.environment = false;
    state_->backdrop.reset();
}

double Renderer::strips_took() const {
    return state_->strips_took;
}

uint64_t Renderer::programs_linked() const {
    return state_->linked;
}

bool Renderer::set_material(const Shader& material, Diagnostics& diagnostics) {
    if (!check_members(material, diagnostics)) return false;
    if (!state_->upload_stale_images(material.reflection.samplers, diagnostics)) return false;
    const bool same_shading = state_->wanted == state_->shading;
    if (!state_->material || !same_shading || state_->material->source != material.source) {
        std::optional<Program> shaded =
            compile(material, View::shaded, nullptr, state_->wanted, diagnostics);
        if (!shaded) return false;
        ++state_->linked;
        state_->shading = state_->wanted;
        state_->programs.clear();
        state_->programs.emplace(State::ProgramKey{}, std::move(*shaded));
    }
    state_->material = material;
    state_->samplers.clear();
    for (const SamplerInfo& sampler : material.reflection.samplers)
        state_->samplers.emplace_back(sampler.options.wrap, sampler.options.filter);
    return true;
}

bool Renderer::set_uniform(std::string_view name, std::span<const float> value) {
    if (!state_->material) return false;
    for (UniformInfo& uniform : state_->material->reflection.uniforms)
        if (uniform.name == name && info(uniform.type).lanes == value.size()) {
            std::copy(value.begin(), value.end(), uniform.value.begin());
            return true;
        }
    return false;
}

bool Renderer::add_image(const std::string& file, const MipChain& chain, Diagnostics& diagnostics) {
    return state_->upload(file, chain, false, diagnostics);
}

void Renderer::forget_images() {
    for (auto& [file, image] : state_->images)
        image.stale = image.is_file;
}

namespace {

bool wants_seen_range(const ViewOptions& options) {
    return options.view == View::height && !options.raw &&
           options.height_range.x == options.height_range.y;
}

// Returns the smallest and largest visible height, from an additional drawing of raw values.
glm::vec2 seen_range(Renderer& renderer, const Scene& scene, const Target& target,
                     Diagnostics& diagnostics) {
    ViewOptions options;
    options.view = View::height;
    options.raw = true;
    const auto numbers =
        Target::make({target.width(), target.height(), PixelFormat::rgba32f}, diagnostics);
    if (!numbers || !renderer.draw(scene, options, *numbers, diagnostics)) return {0, 1};
    constexpr float infinity = std::numeric_limits<float>::infinity();
    glm::vec2 range(infinity, -infinity);
    const std::vector<float> pixels = numbers->read();
    for (size_t i = 0; i < pixels.size(); i += 4) {
        if (pixels[i + 3] == 0 || !std::isfinite(pixels[i])) continue;
        range = {std::min(range.x, pixels[i]), std::max(range.y, pixels[i])};
    }
    if (range.x > range.y) return {0, 1};
    return range.x < range.y ? range : range + glm::vec2(-0.5F, 0.5F);  // one height: mid gray
}

}  // namespace

bool Renderer::draw(const Scene& scene, const ViewOptions& options, const Target& target,
                    Diagnostics& diagnostics) {
    if (!state_->can_draw(diagnostics)) return false;
    const float aspect = static_cast<float>(target.width()) / static_cast<float>(target.height());
    const auto space = object_space(scene.object, scene.camera, state_->mesh->bounds(), aspect);
    if (!space) {
        diagnostics.error("the object matrix cannot be inverted", "no scale of zero");
        return false;
    }
    const Program* program = state_->program_for(options, diagnostics);
    if (!program) return false;
    ViewOptions shown = options;
    if (wants_seen_range(options))
        shown.height_range = seen_range(*this, scene, target, diagnostics);
    clear(target, scene, options.raw);
    if (scene.surroundings && state_->backdrop && options.view == View::shaded && !options.raw)
        state_->backdrop->draw(turned(scene), aspect, scene.environment, scene.exposure);
    program->use();
    set_view_uniforms(*program, scene, shown, *space);
    set_raster_state(space->mirrored);
    program->set("WrView_edges", 0.0F);
    state_->draw_strips(*program, target, options);
    if (options.view == View::wireframe) {
        program->set("WrView_edges", 1.0F);
        set_edges(true);
        state_->draw_mesh(*program);
        set_edges(false);
    }
    target.resolve();
    return true;
}

std::optional<AngleStatistics> Renderer::measure(const Scene& scene, const std::string& against,
                                                 int width, int height, Diagnostics& diagnostics) {
    TargetOptions options{width, height, PixelFormat::rgba32f};
    const std::optional<Target> target = Target::make(options, diagnostics);
    ViewOptions view;
    view.view = View::difference;
    view.against = against;
    view.raw = true;
    if (!target || !draw(scene, view, *target, diagnostics)) return std::nullopt;
    AngleStatistics statistics;
    const std::vector<float> pixels = target->read();
    for (size_t i = 0; i < pixels.size(); i += 4) {
        if (pixels[i + 3] == 0) continue;
        statistics.mean_degrees += pixels[i];
        statistics.max_degrees = std::max<double>(statistics.max_degrees, pixels[i]);
        ++statistics.pixels;
    }
    if (statistics.pixels > 0) statistics.mean_degrees /= static_cast<double>(statistics.pixels);
    return statistics;
}

}  // namespace wrinkle::gpu

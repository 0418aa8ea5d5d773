#include "gpu/renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "emit/attributes.h"
#include "emit/emit.h"
#include "emit/log.h"
#include "gpu/bands.h"
#include "gpu/draw_state.h"
#include "gpu/environment.h"
#include "gpu/mesh_buffers.h"
#include "gpu/object_space.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "gpu/wrapper.h"

namespace wrinkle::gpu {
namespace {

std::string in_quotes(std::string_view text) {
    return "'" + std::string(text) + "'";
}

// Returns the same material with another output as its normal.
Shader with_normal(Shader material, const OutputInfo& normal) {
    auto& outputs = material.reflection.outputs;
    OutputInfo renamed = normal;
    renamed.output = "normal";
    std::erase_if(outputs, [](const OutputInfo& each) { return each.output == "normal"; });
    outputs.push_back(std::move(renamed));
    return material;
}

// The compiled shader numbers the lines of the material's source from 1 (wrapper.h).
Diagnostic refusal(const Reflection& reflection, const std::string& log) {
    Diagnostic problem = {.rule = RuleId::shader_rejected,
                          .message = "the driver refuses the material's shader: " + log};
    const uint32_t node = node_of_line(reflection, line_in(log));
    if (node != no_node) problem.node = reflection.node_paths[node];
    return problem;
}

std::optional<Program> compile(const Shader& material, const ViewRequest& view,
                               Diagnostics& diagnostics) {
    const ShaderText text = wrap_material(material, view);
    std::string log;
    std::optional<Program> program = Program::link(text.vertex, text.fragment, text.outputs, log);
    if (!program) diagnostics.add(refusal(material.reflection, log));
    return program;
}

bool check_members(const Shader& material, Diagnostics& diagnostics) {
    for (const MemberInfo& member : material.reflection.members)
        if (member.variant != Variant::value) {
            diagnostics.error(RuleId::mesh_attribute,
                              "the material reads " + in_quotes(member.name) +
                                  ", which is not a property of a drawn surface");
            return false;
        }
    return true;
}

bool wants_seen_range(const Shader& material, const ViewOptions& options) {
    const OutputInfo* output =
        options.view == View::output ? find_output(material, options.output) : nullptr;
    return (options.view == View::height || (output && is_height(*output))) && !options.raw &&
           options.height_range.x == options.height_range.y;
}

}  // namespace

bool Renderer::upload(const TexelSource& source, const MipChain& chain, bool is_file,
                      Diagnostics& diagnostics) {
    if (chain.levels.empty()) {
        diagnostics.error(RuleId::image_unreadable,
                          "image " + in_quotes(source.file) + " has no texels");
        return false;
    }
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    const Image& image = chain.levels.front();
    if (std::max(image.width, image.height) > static_cast<uint32_t>(limit)) {
        diagnostics.error(
            RuleId::opengl,
            "image " + in_quotes(source.file) + " is larger than this driver can draw",
            "at most " + std::to_string(limit) + " texels a side");
        return false;
    }
    images_.insert_or_assign(
        source, CachedTexture{Texture::upload(chain), bytes_with_mips(chain.levels[0]), is_file});
    return true;
}

bool Renderer::upload_stale_images(const std::vector<SamplerInfo>& needed,
                                   Diagnostics& diagnostics) {
    GLint units = 0;
    glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    --units;  // for the depth of transparent layers
    if (needed.size() > static_cast<size_t>(units)) {
        diagnostics.error(RuleId::opengl,
                          "the material reads " + std::to_string(needed.size()) +
                              " textures, more than this driver binds at once",
                          "at most " + std::to_string(units));
        return false;
    }
    bool ok = true;
    ImageLimits limits = image_limits_from_environment(diagnostics);
    limits.left_bytes = limit_of(Limit::all_images_bytes);
    for (const SamplerInfo& sampler : needed) {
        const TexelSource source = texels_of(sampler);
        const auto cached = images_.find(source);
        if (cached == images_.end() || cached->second.stale) {
            const auto chain = load_texels(source, limits, diagnostics);
            ok = chain && upload(source, *chain, true, diagnostics) && ok;
        }
        if (const auto now = images_.find(source); now != images_.end())
            limits.left_bytes -= std::min(limits.left_bytes, now->second.bytes);
    }
    return ok;
}

bool Renderer::has_outputs(const ViewOptions& options, Diagnostics& diagnostics) const {
    for (const std::string& name : {options.against, options.normal})
        if (!name.empty() && name != "normal" && !find_output(*material_, name)) {
            diagnostics.error(RuleId::unknown_output,
                              "the graph has no output " + in_quotes(name) + " to compare with");
            return false;
        }
    const std::string& shown = options.view == View::height ? "height" : options.output;
    if (shown.empty() || find_output(*material_, shown)) return true;
    diagnostics.error(RuleId::unknown_output,
                      "the graph has no output " + in_quotes(shown) + " to show",
                      "an output named " + in_quotes(shown));
    return false;
}

const Program* Renderer::program_for(const ViewOptions& options, Diagnostics& diagnostics) {
    const std::string against = options.view == View::difference ? options.against : "";
    const std::string output = options.view == View::output ? options.output : "";
    const ProgramKey key{options.view, options.normal, against, output};
    if (const auto found = programs_.find(key); found != programs_.end()) return &found->second;
    if (!has_outputs(options, diagnostics)) return nullptr;
    const OutputInfo* normal = find_output(*material_, options.normal);
    const bool usual = !normal || options.normal == "normal";
    std::optional<Program> program =
        compile(usual ? *material_ : with_normal(*material_, *normal),
                {options.view, find_output(*material_, against), find_output(*material_, output)},
                diagnostics);
    if (!program) return nullptr;
    ++linked_;
    return &programs_.emplace(key, std::move(*program)).first->second;
}

bool Renderer::can_draw(Diagnostics& diagnostics) const {
    if (!mesh_ || !material_) {
        diagnostics.error(RuleId::option,
                          "there is nothing to draw: a mesh and a material are needed");
        return false;
    }
    bool ok = true;
    for (const MemberInfo& member : material_->reflection.members) {
        const int location = location_of(member.input);
        if (location < 0 || mesh_->has(location)) continue;
        diagnostics.error(RuleId::mesh_attribute,
                          "the material reads " + in_quotes(info(member.input).name) +
                              ", which the mesh does not have",
                          "a mesh that has it, or a graph that reads another one");
        ok = false;
    }
    return ok;
}

void Renderer::draw_mesh(const Program& program) const {
    for (size_t i = 0; i < samplers_.size(); ++i) {
        const SamplerInfo& sampler = material_->reflection.samplers[i];
        images_.at(texels_of(sampler)).texture.bind(static_cast<int>(i));
        samplers_[i].bind(static_cast<int>(i));
        program.set(sampler.name.c_str(), static_cast<int>(i));
    }
    for (const UniformInfo& uniform : material_->reflection.uniforms)
        program.set(uniform);
    mesh_->draw();
    for (size_t i = 0; i < samplers_.size(); ++i)
        glBindSampler(static_cast<GLuint>(i), 0);  // so that other drawing is not affected
}

void Renderer::set_environment(const Image& image) {
    shaded_.set_environment(EnvironmentTexture(prefilter(image)));
    background_.set_environment(radiance_of(image));
}

void Renderer::set_mood(Mood mood) {
    set_environment(environment_of(mood));
}

bool Renderer::set_material(const Shader& material, Diagnostics& diagnostics) {
    if (!check_members(material, diagnostics)) return false;
    if (!upload_stale_images(material.reflection.samplers, diagnostics)) return false;
    if (!material_ || material_->source != material.source) {
        std::optional<Program> shaded = compile(material, {View::shaded}, diagnostics);
        if (!shaded) return false;
        ++linked_;
        programs_.clear();
        programs_.emplace(ProgramKey{}, std::move(*shaded));
    }
    material_ = material;
    samplers_.clear();
    for (const SamplerInfo& sampler : material.reflection.samplers)
        samplers_.emplace_back(sampler.options.wrap, sampler.options.filter);
    return true;
}

bool Renderer::set_uniform(std::string_view name, std::span<const float> value) {
    if (!material_) return false;
    for (UniformInfo& uniform : material_->reflection.uniforms)
        if (uniform.name == name && info(uniform.type).lanes == value.size()) {
            std::copy(value.begin(), value.end(), uniform.value.begin());
            return true;
        }
    return false;
}

bool Renderer::add_image(const TexelSource& source, const MipChain& chain,
                         Diagnostics& diagnostics) {
    return upload(source, chain, false, diagnostics);
}

void Renderer::forget_images() {
    for (auto& [source, image] : images_)
        image.stale = image.is_file;
}

// Returns the smallest and largest visible value, from an additional drawing of raw values.
glm::vec2 Renderer::seen_range(const Scene& scene, ViewOptions options, const Target& target,
                               Diagnostics& diagnostics) {
    options.raw = true;
    const auto numbers =
        Target::make({target.width(), target.height(), PixelFormat::rgba32f}, diagnostics);
    if (!numbers || !draw(scene, options, *numbers, diagnostics)) return {0, 1};
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

bool Renderer::draw_shaded(const Program& program, const Scene& scene, const ViewOptions& options,
                           const Target& target, const ObjectSpace& space,
                           Diagnostics& diagnostics) {
    target.bind_resolved();
    clear(scene, options.raw);
    const float aspect = static_cast<float>(target.width()) / static_cast<float>(target.height());
    if (!options.raw && !background_.draw(scene, aspect, space.in_world, diagnostics)) return false;
    const auto draw = [&] {
        set_view_uniforms(program, options, space);
        draw_mesh(program);
    };
    const MaterialPass material{program,
                                surface_model(*material_),
                                find_output(*material_, "opacity") != nullptr,
                                space.mirrored,
                                static_cast<int>(samplers_.size()),
                                draw};
    const bool drawn = shaded_.draw(material, scene, options, target, diagnostics);
    strips_took_ = shaded_.strips_took();
    return drawn;
}

void Renderer::draw_values(const Program& program, const ViewOptions& options, const Target& target,
                           const ObjectSpace& space) {
    program.use();
    set_view_uniforms(program, options, space);
    set_raster_state(space.mirrored);
    program.set("WrView_edges", 0.0F);
    Bands bands(
        {target.height(), target.height() + 1, options.strip_milliseconds, options.before_strip});
    while (const auto band = bands.next()) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, band->low, target.width(), band->rows);
        draw_mesh(program);
    }
    glDisable(GL_SCISSOR_TEST);
    strips_took_ = bands.milliseconds();
    if (options.view == View::wireframe) {
        program.set("WrView_edges", 1.0F);
        set_edges(true);
        draw_mesh(program);
        set_edges(false);
    }
}

bool Renderer::draw(const Scene& scene, const ViewOptions& options, const Target& target,
                    Diagnostics& diagnostics) {
    if (!can_draw(diagnostics)) return false;
    const float aspect = static_cast<float>(target.width()) / static_cast<float>(target.height());
    const auto space = object_space(scene.object, scene.camera, mesh_->bounds(), aspect);
    if (!space) {
        diagnostics.error(RuleId::option, "the object matrix cannot be inverted",
                          "no scale of zero");
        return false;
    }
    const Program* program = program_for(options, diagnostics);
    if (!program) return false;
    if (options.view == View::shaded)
        return draw_shaded(*program, scene, options, target, *space, diagnostics);
    ViewOptions shown = options;
    if (wants_seen_range(*material_, options))
        shown.height_range = seen_range(scene, options, target, diagnostics);
    target.bind();
    clear(scene, options.raw);
    draw_values(*program, shown, target, *space);
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

#include "gpu/shaded_view.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "gpu/albedo.h"
#include "gpu/bands.h"
#include "gpu/covering.h"
#include "gpu/display.h"
#include "gpu/draw_state.h"
#include "gpu/lighting_text.h"
#include "gpu/renderer.h"
#include "gpu/studio.h"

namespace wrinkle::gpu {
namespace {

// Bounds the memory of the buffers, 130 bytes a sample.
constexpr int most_samples_of_a_band = 1 << 20;

constexpr std::string_view light_main = R"(
void main() {
    WrView_Surface s = WrView_read(ivec2(gl_FragCoord.xy));
    if (s.opacity == 0.0) discard;
    vec3 radiance = WrView_lit(s, normalize(-WrView_direction));
    WrView_color = vec4(max(radiance, 0.0) * s.opacity, s.opacity);
}
)";

// The tone curve comes before the average, so that a highlight does not outweigh an edge.
constexpr std::string_view resolve_text = R"(
uniform sampler2D WrView_radiance;
uniform int WrView_origin;  // of the radiance, row of the target
uniform int WrView_across;  // samples per side of a pixel
uniform bool WrView_raw;

void main() {
    ivec2 first = (ivec2(gl_FragCoord.xy) - ivec2(0, WrView_origin)) * WrView_across;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < WrView_across * WrView_across; ++i) {
        ivec2 at = first + ivec2(i % WrView_across, i / WrView_across);
        vec4 c = texelFetch(WrView_radiance, at, 0);
        if (!WrView_raw && c.a > 0.0) c.rgb = WrView_display(c.rgb / c.a) * c.a;
        sum += c;
    }
    WrView_color = sum / float(WrView_across * WrView_across);
}
)";

void scissor(int width, int low, int rows) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, low, width, rows);
}

}  // namespace

struct ShadedView::Frame {
    const MaterialPass& material;
    const Scene& scene;
    const ViewOptions& options;
    const Target& target;
    const Program* lighting = nullptr;
    int across = 1;  // samples per side of a pixel

    int width() const { return target.width() * across; }
    int height() const { return target.height() * across; }
    float aspect() const {
        return static_cast<float>(target.width()) / static_cast<float>(target.height());
    }
    int most_rows() const {
        const int rows = most_samples_of_a_band / (width() * across) / 2 * 2;
        return std::clamp(rows, 2, target.height() + target.height() % 2);
    }
};

bool ShadedView::prepare(Frame& frame, Diagnostics& diagnostics) {
    const int height = frame.most_rows() * frame.across;
    const int texels = surface_texels(frame.material.model);
    if (!surface_ || !surface_->fits(frame.width(), height, texels))
        surface_ = SurfaceBuffer::make(frame.width(), height, texels, diagnostics);
    if (!radiance_ || radiance_->width() != frame.width() || radiance_->height() != height)
        radiance_ = Target::make({frame.width(), height, PixelFormat::rgba32f}, diagnostics);
    if (!albedos_) {
        static const std::vector<glm::vec4> table = albedo_table();
        linear_.emplace(Wrap::clamp, Filter::linear);
        albedos_ = Texture::of_floats(albedo_side, albedo_side, {&table[0].x, 4 * table.size()});
    }
    if (!environment_) {
        static const EnvironmentCube studio = prefilter(environment_of(Mood::studio));
        environment_.emplace(studio);
    }
    frame.lighting = lighting_for(frame.material.model, frame.scene.lighting, diagnostics);
    if (!resolve_)
        resolve_ = link_covering(std::string(display_text()).append(resolve_text), diagnostics);
    return surface_ && radiance_ && frame.lighting && resolve_;
}

const Program* ShadedView::lighting_for(SurfaceModel model, Lighting lighting,
                                        Diagnostics& diagnostics) {
    const std::pair key(model, lighting);
    if (const auto found = lightings_.find(key); found != lightings_.end()) return &found->second;
    std::string text = unpack_surface(model);
    text += lighting == Lighting::phong ? std::string(phong_text()) : ggx_text(model);
    auto program = link_covering(text.append(light_main), diagnostics);
    return program ? &lightings_.emplace(key, std::move(*program)).first->second : nullptr;
}

bool ShadedView::draw(const MaterialPass& material, const Scene& scene, const ViewOptions& options,
                      const Target& target, Diagnostics& diagnostics) {
    Frame frame{material, scene, options, target};
    frame.across = options.raw || options.samples < 4 ? 1 : 2;
    if (!prepare(frame, diagnostics)) return false;
    Bands bands(
        {target.height(), frame.most_rows(), options.strip_milliseconds, options.before_strip});
    while (const auto band = bands.next()) {
        draw_layers(frame, *band);
        resolve(frame, *band);
    }
    strips_took_ = bands.milliseconds();
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    return true;
}

// The viewport is that of the entire target, shifted by the origin of the buffers.
void ShadedView::draw_layers(const Frame& frame, const Band& band) {
    const auto see_band = [&] {
        glViewport(0, -band.origin * frame.across, frame.width(), frame.height());
        scissor(frame.width(), (band.low - band.origin) * frame.across, band.rows * frame.across);
    };
    radiance_->bind();
    see_band();
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    const int layers = frame.material.transparent ? most_layers : 1;
    const int nearer = frame.material.free_unit;
    auto seen = QueryHandle::make();
    for (int layer = 0; layer < layers; ++layer) {
        see_band();
        surface_->begin_layer(layer);
        surface_->bind_nearer(nearer, layer);
        frame.material.program.use();
        frame.material.program.set("WrView_nearer", nearer);
        frame.material.program.set("WrView_layer", layer);
        set_raster_state(frame.material.mirrored);
        glBeginQuery(GL_ANY_SAMPLES_PASSED, seen.id());
        frame.material.draw();
        glEndQuery(GL_ANY_SAMPLES_PASSED);
        if (layer > 0) {
            GLuint any = 0;
            glGetQueryObjectuiv(seen.id(), GL_QUERY_RESULT, &any);
            if (!any) break;
        }
        radiance_->bind();
        see_band();
        light_layer(frame);
    }
}

void ShadedView::light_layer(const Frame& frame) {
    const Program& program = *frame.lighting;
    const Scene& scene = frame.scene;
    program.use();
    set_rays(program, scene.camera, frame.aspect());
    program.set("WrView_to_light", glm::normalize(scene.to_light));
    program.set("WrView_light", scene.light);
    program.set("WrView_environment", scene.environment);
    program.set("WrView_environment_turn",
                glm::vec2(std::cos(scene.environment_turn), std::sin(scene.environment_turn)));
    const Phong& phong = scene.phong;
    program.set("WrView_phong",
                glm::vec4(phong.ambient, phong.diffuse, phong.specular, phong.shininess));
    const int texels = surface_texels(frame.material.model);
    surface_->bind_texels(0);
    for (int i = 0; i < texels; ++i)
        program.set(("WrView_texel" + std::to_string(i)).c_str(), i);
    environment_->bind(texels, texels + 1);
    program.set("WrView_reflections", texels);
    program.set("WrView_irradiances", texels + 1);
    albedos_->bind(texels + 2);
    linear_->bind(texels + 2);
    program.set("WrView_albedos", texels + 2);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);  // behind the layers that are nearer
    glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    draw_covering_triangle();
    glBindSampler(static_cast<GLuint>(texels + 2), 0);
}

void ShadedView::resolve(const Frame& frame, const Band& band) {
    frame.target.bind_resolved();
    scissor(frame.target.width(), band.low, band.rows);
    resolve_->use();
    set_display_uniforms(*resolve_, frame.scene);
    resolve_->set("WrView_radiance", 0);
    resolve_->set("WrView_origin", band.origin);
    resolve_->set("WrView_across", frame.across);
    resolve_->set("WrView_raw", frame.options.raw ? 1 : 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, radiance_->texture());
    glDisable(GL_DEPTH_TEST);
    (frame.options.raw ? glDisable : glEnable)(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw_covering_triangle();
}

}  // namespace wrinkle::gpu

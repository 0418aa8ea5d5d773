#include "gpu/background.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "gpu/covering.h"
#include "gpu/display.h"
#include "gpu/renderer.h"
#include "gpu/studio.h"

namespace wrinkle::gpu {
namespace {

constexpr std::string_view environment_text = R"(
uniform sampler2D WrView_image;
uniform float WrView_factor;

void main() {
    vec3 d = normalize(WrView_direction);
    vec2 uv = vec2(atan(d.x, -d.z) / 6.283185307, asin(clamp(d.y, -1.0, 1.0)) / 3.141592654) + 0.5;
    vec3 radiance = textureLod(WrView_image, uv, 0.0).rgb * WrView_factor;
    WrView_color = vec4(WrView_display(radiance), 1.0);
}
)";

// A paper backdrop that is lighter in the upper half and falls off to the corners. The floor is in
// the shadow of a sphere: the part of the sky that it covers, and the part of the key light.
constexpr std::string_view studio_text = R"(
uniform vec2 WrView_size;     // of the target, pixels
uniform vec3 WrView_eye;
uniform vec3 WrView_center;   // of the sphere
uniform float WrView_radius;  // 0: no shadow
uniform vec3 WrView_to_key;

float WrView_floor_light(vec3 at) {
    vec3 to_center = (WrView_center - at) / WrView_radius;
    float q = length(to_center.xz);
    float sky = 1.0 - 0.8 * pow(1.0 + q * q, -1.5);
    float miss = length(to_center - WrView_to_key * max(dot(to_center, WrView_to_key), 0.0));
    float key = 1.0 - 0.45 * (1.0 - smoothstep(0.35, 1.55, miss));
    return mix(sky * key, 1.0, smoothstep(2.5, 6.0, q));
}

void main() {
    vec2 at = gl_FragCoord.xy / WrView_size;
    vec3 paper = mix(vec3(0.115, 0.118, 0.125), vec3(0.235, 0.238, 0.245),
                     smoothstep(0.05, 0.62, at.y));
    vec2 from_middle = (gl_FragCoord.xy - 0.5 * WrView_size) / WrView_size.y;
    paper *= 1.0 - 0.55 * min(1.0, 1.3 * dot(from_middle, from_middle));
    float above = WrView_eye.y - (WrView_center.y - WrView_radius);
    if (WrView_radius > 0.0 && above > 0.0 && WrView_direction.y < 0.0)
        paper *= WrView_floor_light(WrView_eye + WrView_direction * (above / -WrView_direction.y));
    WrView_color = vec4(WrView_encode(paper), 1.0);
}
)";

}  // namespace

void Background::set_environment(const MipChain& radiance) {
    map_.emplace(Map{Texture::upload(radiance), Sampler(Wrap::repeat, Filter::linear)});
}

bool Background::draw(const Scene& scene, float aspect, const Bounds& object,
                      Diagnostics& diagnostics) {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    switch (scene.behind) {
        case Behind::plain:
            return true;
        case Behind::studio:
            return draw_studio(scene, aspect, object, diagnostics);
        case Behind::environment:
            return draw_environment(scene, aspect, diagnostics);
    }
    return true;
}

bool Background::draw_environment(const Scene& scene, float aspect, Diagnostics& diagnostics) {
    if (!map_) return true;
    if (!environment_)
        environment_ =
            link_covering(std::string(display_text()).append(environment_text), diagnostics);
    if (!environment_) return false;
    environment_->use();
    // The scene's view of the turned environment is this camera's view of the unturned one.
    OrbitCamera camera = scene.camera;
    camera.yaw -= scene.environment_turn;
    set_rays(*environment_, camera, aspect);
    set_display_uniforms(*environment_, scene);
    environment_->set("WrView_factor", scene.environment);
    environment_->set("WrView_image", 0);
    map_->texture.bind(0);
    map_->sampler.bind(0);
    draw_covering_triangle();
    glBindSampler(0, 0);
    return true;
}

bool Background::draw_studio(const Scene& scene, float aspect, const Bounds& object,
                             Diagnostics& diagnostics) {
    if (!studio_)
        studio_ = link_covering(std::string(encode_text()).append(studio_text), diagnostics);
    if (!studio_) return false;
    studio_->use();
    set_rays(*studio_, scene.camera, aspect);
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    studio_->set("WrView_size", glm::vec2(viewport[2], viewport[3]));
    const glm::vec3 extent = object.high - object.low;
    const float radius = std::min(extent.x, extent.z) / 2;
    glm::vec3 center = object.center();
    center.y = object.low.y + radius;
    studio_->set("WrView_eye", glm::vec3(eye_of(scene.camera)));
    studio_->set("WrView_center", center);
    studio_->set("WrView_radius", radius);
    studio_->set("WrView_to_key", light_direction(scene.environment_turn));
    draw_covering_triangle();
    return true;
}

}  // namespace wrinkle::gpu

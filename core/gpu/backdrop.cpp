#include "gpu/backdrop.h"

#include <epoxy/gl.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "gpu/draw_state.h"
#include "gpu/wrapper.h"

namespace wrinkle::gpu {
namespace {

// One triangle that covers the target; the view direction is interpolated linearly across it.
constexpr const char* backdrop_vertex_text = R"(#version 330 core
uniform vec3 WrView_forward;
uniform vec3 WrView_right;
uniform vec3 WrView_up;
out vec3 WrView_direction;

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    WrView_direction = WrView_forward + corner.x * WrView_right + corner.y * WrView_up;
    gl_Position = vec4(corner, 1.0, 1.0);
}
)";

constexpr const char* fragment_head = R"(#version 330 core
in vec3 WrView_direction;
out vec4 WrView_color;
uniform sampler2D WrView_image;
uniform float WrView_factor;
)";

constexpr const char* fragment_body = R"(
void main() {
    vec3 d = normalize(WrView_direction);
    vec2 uv = vec2(atan(d.x, -d.z) / 6.283185307, asin(clamp(d.y, -1.0, 1.0)) / 3.141592654) + 0.5;
    vec3 radiance = textureLod(WrView_image, uv, 0.0).rgb * WrView_factor;
    WrView_color = vec4(WrView_display(radiance), 1.0);
}
)";

}  // namespace

Backdrop::Backdrop(const MipChain& radiance)
    : texture_(Texture::upload(radiance)), sampler_(Wrap::repeat, Filter::linear) {
    const std::array<std::string, 1> outputs{"WrView_color"};
    std::string log;
    program_ = Program::link(backdrop_vertex_text,
                             std::string(fragment_head).append(display_text()) + fragment_body,
                             outputs, log);
}

void Backdrop::draw(const Scene& scene, float aspect) const {
    if (!program_) return;
    // The scene's view of the rotated environment is this camera's view of the unrotated one.
    OrbitCamera camera = scene.camera;
    camera.yaw -= scene.environment_turn;
    // Rows of the view matrix: the camera's axes in the world.
    const glm::dmat4 view = view_matrix(camera);
    const auto axis = [&](int row) { return glm::vec3(view[0][row], view[1][row], view[2][row]); };
    const float half = std::tan(camera.field_of_view / 2);
    program_->use();
    program_->set("WrView_forward", -axis(2));
    program_->set("WrView_right", axis(0) * half * std::fmax(aspect, 1.0F));
    program_->set("WrView_up", axis(1) * half / std::fmin(aspect, 1.0F));
    program_->set("WrView_factor", scene.environment);
    program_->set("WrView_exposure", scene.exposure);
    program_->set("WrView_image", 0);
    texture_.bind(0);
    sampler_.bind(0);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    draw_covering_triangle();
    glBindSampler(0, 0);
}

}  // namespace wrinkle::gpu

#include "gpu/covering.h"

#include <epoxy/gl.h>

#include <array>

#include "gpu/gl_handle.h"

namespace wrinkle::gpu {
namespace {

constexpr const char* covering_vertex = R"(#version 330 core
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

constexpr const char* covering_fragment_head = R"(#version 330 core
in vec3 WrView_direction;
out vec4 WrView_color;
)";

}  // namespace

std::optional<Program> link_covering(const std::string& fragment, Diagnostics& diagnostics) {
    const std::array<std::string, 1> outputs{"WrView_color"};
    std::string log;
    auto program = Program::link(covering_vertex, covering_fragment_head + fragment, outputs, log);
    if (!program)
        diagnostics.error(RuleId::shader_rejected,
                          "the driver rejects a shader of the shaded view: " + log);
    return program;
}

void set_rays(const Program& program, const OrbitCamera& camera, float aspect) {
    const Rays rays = rays_of(camera, aspect);
    program.set("WrView_forward", rays.forward);
    program.set("WrView_right", rays.right);
    program.set("WrView_up", rays.up);
}

void draw_covering_triangle() {
    const auto array = VertexArrayHandle::make();
    glBindVertexArray(array.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

}  // namespace wrinkle::gpu

#include "gpu/draw_state.h"

#include <epoxy/gl.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace wrinkle::gpu {

void set_view_uniforms(const Program& program, const Scene& scene, const ViewOptions& options,
                       const ObjectSpace& space) {
    program.set("WrView_to_clip", space.to_clip);
    program.set("WrView_eye", space.eye);
    program.set("WrView_vector_to_world", space.vector_to_world);
    program.set("WrView_normal_to_world", space.normal_to_world);
    program.set("WrView_to_light", glm::normalize(scene.to_light));
    program.set("WrView_light", scene.light);
    program.set("WrView_environment", scene.environment);
    program.set("WrView_environment_turn",
                glm::vec2(std::cos(scene.environment_turn), std::sin(scene.environment_turn)));
    program.set("WrView_exposure", scene.exposure);
    const Phong& phong = scene.phong;
    program.set("WrView_phong",
                glm::vec4(phong.ambient, phong.diffuse, phong.specular, phong.shininess));
    program.set("WrView_raw", options.raw ? 1 : 0);
    program.set("WrView_heat_degrees", options.heat_degrees);
    program.set("WrView_height_range", options.height_range);
}

void clear(const Target& target, const Scene& scene, bool raw) {
    target.bind();
    const glm::vec4 color = raw ? glm::vec4(0) : scene.background;
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glClearColor(color.r, color.g, color.b, color.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void set_raster_state(bool mirrored) {
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glFrontFace(mirrored ? GL_CW : GL_CCW);
}

void draw_covering_triangle() {
    const auto array = VertexArrayHandle::make();
    glBindVertexArray(array.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

void set_edges(bool on) {
    glPolygonMode(GL_FRONT_AND_BACK, on ? GL_LINE : GL_FILL);
    glPolygonOffset(-1, -1);
    (on ? glEnable : glDisable)(GL_POLYGON_OFFSET_LINE);
}

}  // namespace wrinkle::gpu

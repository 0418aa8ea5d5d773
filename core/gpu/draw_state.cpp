#include "gpu/draw_state.h"

#include <epoxy/gl.h>

namespace wrinkle::gpu {

void set_view_uniforms(const Program& program, const ViewOptions& options,
                       const ObjectSpace& space) {
    program.set("WrView_to_clip", space.to_clip);
    program.set("WrView_eye", space.eye);
    program.set("WrView_vector_to_world", space.vector_to_world);
    program.set("WrView_normal_to_world", space.normal_to_world);
    program.set("WrView_raw", options.raw ? 1 : 0);
    program.set("WrView_heat_degrees", options.heat_degrees);
    program.set("WrView_height_range", options.height_range);
}

void clear(const Scene& scene, bool raw) {
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

void set_edges(bool on) {
    glPolygonMode(GL_FRONT_AND_BACK, on ? GL_LINE : GL_FILL);
    glPolygonOffset(-1, -1);
    (on ? glEnable : glDisable)(GL_POLYGON_OFFSET_LINE);
}

}  // namespace wrinkle::gpu

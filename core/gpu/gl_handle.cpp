#include "gpu/gl_handle.h"

#include <epoxy/gl.h>

namespace wrinkle::gpu {

void delete_buffer(uint32_t id) {
    glDeleteBuffers(1, &id);
}

void delete_framebuffer(uint32_t id) {
    glDeleteFramebuffers(1, &id);
}

void delete_program(uint32_t id) {
    glDeleteProgram(id);
}

void delete_renderbuffer(uint32_t id) {
    glDeleteRenderbuffers(1, &id);
}

void delete_sampler(uint32_t id) {
    glDeleteSamplers(1, &id);
}

void delete_texture(uint32_t id) {
    glDeleteTextures(1, &id);
}

void delete_vertex_array(uint32_t id) {
    glDeleteVertexArrays(1, &id);
}

}  // namespace wrinkle::gpu

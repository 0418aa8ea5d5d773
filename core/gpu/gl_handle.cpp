#include "gpu/gl_handle.h"

#include <epoxy/gl.h>

#include <array>

namespace wrinkle::gpu {
namespace {

// GL's functions of a kind of object. libepoxy declares each as a variable.
struct Functions {
    PFNGLGENTEXTURESPROC* create;
    PFNGLDELETETEXTURESPROC* destroy;
};

// By GlKind; programs have functions of another signature.
constexpr std::array<Functions, 7> functions{{{&glGenBuffers, &glDeleteBuffers},
                                              {&glGenFramebuffers, &glDeleteFramebuffers},
                                              {&glGenQueries, &glDeleteQueries},
                                              {&glGenRenderbuffers, &glDeleteRenderbuffers},
                                              {&glGenSamplers, &glDeleteSamplers},
                                              {&glGenTextures, &glDeleteTextures},
                                              {&glGenVertexArrays, &glDeleteVertexArrays}}};

}  // namespace

uint32_t create_gl_object(GlKind kind) {
    if (kind == GlKind::program) return glCreateProgram();
    uint32_t id = 0;
    (*functions[static_cast<size_t>(kind)].create)(1, &id);
    return id;
}

void delete_gl_object(GlKind kind, uint32_t id) {
    if (kind == GlKind::program) return glDeleteProgram(id);
    (*functions[static_cast<size_t>(kind)].destroy)(1, &id);
}

}  // namespace wrinkle::gpu

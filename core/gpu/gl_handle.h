// Owners of GL objects. A handle is movable; its destructor deletes the object and requires a
// current context of the share group (of the same context for vertex arrays and framebuffers).
#pragma once

#include <cstdint>
#include <utility>

namespace wrinkle::gpu {

enum class GlKind {
    buffer,
    framebuffer,
    query,
    renderbuffer,
    sampler,
    texture,
    vertex_array,
    program
};

uint32_t create_gl_object(GlKind kind);
void delete_gl_object(GlKind kind, uint32_t id);

template <GlKind kind>
class GlHandle {
public:
    GlHandle() = default;
    static GlHandle make() {
        GlHandle made;
        made.id_ = create_gl_object(kind);
        return made;
    }
    GlHandle(GlHandle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlHandle& operator=(GlHandle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    ~GlHandle() {
        if (id_) delete_gl_object(kind, id_);
    }

    uint32_t id() const { return id_; }  // 0 if it owns nothing

private:
    uint32_t id_ = 0;
};

using BufferHandle = GlHandle<GlKind::buffer>;
using FramebufferHandle = GlHandle<GlKind::framebuffer>;
using ProgramHandle = GlHandle<GlKind::program>;
using QueryHandle = GlHandle<GlKind::query>;
using RenderbufferHandle = GlHandle<GlKind::renderbuffer>;
using SamplerHandle = GlHandle<GlKind::sampler>;
using TextureHandle = GlHandle<GlKind::texture>;
using VertexArrayHandle = GlHandle<GlKind::vertex_array>;

}  // namespace wrinkle::gpu

// Owners of GL objects. A handle is movable; its destructor deletes the object and requires a
// current context of the share group (of the same context for vertex arrays and framebuffers).
#pragma once

#include <cstdint>
#include <utility>

namespace wrinkle::gpu {

template <void (*destroy)(uint32_t)>
class GlHandle {
public:
    GlHandle() = default;
    explicit GlHandle(uint32_t id) : id_(id) {}
    GlHandle(GlHandle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlHandle& operator=(GlHandle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    ~GlHandle() {
        if (id_) destroy(id_);
    }

    uint32_t id() const { return id_; }  // 0 if it owns nothing

private:
    uint32_t id_ = 0;
};

void delete_buffer(uint32_t id);
void delete_framebuffer(uint32_t id);
void delete_program(uint32_t id);
void delete_renderbuffer(uint32_t id);
void delete_sampler(uint32_t id);
void delete_texture(uint32_t id);
void delete_vertex_array(uint32_t id);

using BufferHandle = GlHandle<delete_buffer>;
using FramebufferHandle = GlHandle<delete_framebuffer>;
using ProgramHandle = GlHandle<delete_program>;
using RenderbufferHandle = GlHandle<delete_renderbuffer>;
using SamplerHandle = GlHandle<delete_sampler>;
using TextureHandle = GlHandle<delete_texture>;
using VertexArrayHandle = GlHandle<delete_vertex_array>;

}  // namespace wrinkle::gpu

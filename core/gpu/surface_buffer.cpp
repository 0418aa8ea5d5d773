#include "gpu/surface_buffer.h"

#include <epoxy/gl.h>

#include <string>

namespace wrinkle::gpu {
namespace {

void allocate(const TextureHandle& texture, GLenum internal, GLenum format, GLenum type, int width,
              int height) {
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal), width, height, 0, format, type,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void bind_texture(int unit, const TextureHandle& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.id());
}

}  // namespace

std::optional<SurfaceBuffer> SurfaceBuffer::make(int width, int height, int texels,
                                                 Diagnostics& diagnostics) {
    SurfaceBuffer buffer;
    buffer.width_ = width;
    buffer.height_ = height;
    if (buffer.build(texels)) return buffer;
    diagnostics.error(RuleId::opengl, "the driver cannot shade " + std::to_string(width) + "x" +
                                          std::to_string(height) + " pixels at once");
    return std::nullopt;
}

bool SurfaceBuffer::build(int texels) {
    while (glGetError() != GL_NO_ERROR) {
    }
    glActiveTexture(GL_TEXTURE0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    std::vector<GLenum> attachments;
    for (int i = 0; i < texels; ++i) {
        texels_.push_back(TextureHandle::make());
        allocate(texels_.back(), GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, width_, height_);
        attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachments.back(), GL_TEXTURE_2D,
                               texels_.back().id(), 0);
    }
    glDrawBuffers(texels, attachments.data());
    for (const TextureHandle& depth : depths_)
        allocate(depth, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, width_, height_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_[0].id(), 0);
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE &&
           glGetError() == GL_NO_ERROR;
}

bool SurfaceBuffer::fits(int width, int height, int texels) const {
    return width_ == width && height_ == height && texels_.size() == static_cast<size_t>(texels);
}

void SurfaceBuffer::begin_layer(int layer) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                           depths_[static_cast<size_t>(layer % 2)].id(), 0);
    constexpr std::array<GLuint, 4> empty{};
    for (size_t i = 0; i < texels_.size(); ++i)
        glClearBufferuiv(GL_COLOR, static_cast<GLint>(i), empty.data());
    glClear(GL_DEPTH_BUFFER_BIT);
}

void SurfaceBuffer::bind_nearer(int unit, int layer) const {
    bind_texture(unit, depths_[static_cast<size_t>((layer + 1) % 2)]);
}

void SurfaceBuffer::bind_texels(int first_unit) const {
    for (size_t i = 0; i < texels_.size(); ++i)
        bind_texture(first_unit + static_cast<int>(i), texels_[i]);
}

}  // namespace wrinkle::gpu

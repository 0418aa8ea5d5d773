#include "gpu/target.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace wrinkle::gpu {
namespace {

GLint limit_of(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

GLenum internal_format(PixelFormat format) {
    return format == PixelFormat::rgba8 ? GL_RGBA8 : GL_RGBA32F;
}

FramebufferHandle make_framebuffer() {
    auto framebuffer = FramebufferHandle::make();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    return framebuffer;
}

GLenum attachment(size_t color) {
    return GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(color);
}

TextureHandle make_color_texture(const TargetOptions& options) {
    auto texture = TextureHandle::make();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    const GLenum type = options.format == PixelFormat::rgba8 ? GL_UNSIGNED_BYTE : GL_FLOAT;
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format(options.format)),
                 options.width, options.height, 0, GL_RGBA, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

RenderbufferHandle attach_buffer(GLenum where, GLenum format, const TargetOptions& options) {
    auto buffer = RenderbufferHandle::make();
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
    const GLsizei samples = options.samples > 1 ? options.samples : 0;
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, options.width,
                                     options.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer.id());
    return buffer;
}

void draw_to_all_colors(size_t count) {
    std::vector<GLenum> buffers;
    for (size_t i = 0; i < count; ++i)
        buffers.push_back(attachment(i));
    glDrawBuffers(static_cast<GLsizei>(count), buffers.data());
}

bool is_complete() {
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace

std::optional<Target> Target::make(const TargetOptions& options, Diagnostics& diagnostics) {
    const GLint limit = std::min(limit_of(GL_MAX_TEXTURE_SIZE), limit_of(GL_MAX_RENDERBUFFER_SIZE));
    const auto fits = [&](int side) { return side >= 1 && side <= limit; };
    const std::string size = std::to_string(options.width) + "x" + std::to_string(options.height);
    if (!fits(options.width) || !fits(options.height)) {
        diagnostics.error(RuleId::opengl, "an image of " + size + " pixels cannot be drawn",
                          "1 to " + std::to_string(limit) + " pixels a side");
        return std::nullopt;
    }
    Target target;
    target.options_ = options;
    target.options_.colors = std::clamp(options.colors, 1, limit_of(GL_MAX_COLOR_ATTACHMENTS));
    target.options_.samples = std::clamp(options.samples, 1, limit_of(GL_MAX_SAMPLES));
    if (!target.build()) {
        diagnostics.error(RuleId::opengl,
                          "the driver cannot draw into an image of " + size + " pixels");
        return std::nullopt;
    }
    return target;
}

bool Target::build() {
    while (glGetError() != GL_NO_ERROR) {
    }
    framebuffer_ = make_framebuffer();
    for (size_t i = 0; i < static_cast<size_t>(options_.colors); ++i) {
        textures_.push_back(make_color_texture(options_));
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment(i), GL_TEXTURE_2D,
                               texture(static_cast<int>(i)), 0);
    }
    draw_to_all_colors(textures_.size());
    const bool complete = is_complete();
    if (options_.samples > 1) {
        sample_framebuffer_ = make_framebuffer();
        buffers_.push_back(
            attach_buffer(attachment(0), internal_format(options_.format), options_));
    }
    buffers_.push_back(attach_buffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, options_));
    return complete && is_complete() && glGetError() == GL_NO_ERROR;
}

void Target::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER,
                      (sample_framebuffer_.id() ? sample_framebuffer_ : framebuffer_).id());
    glViewport(0, 0, options_.width, options_.height);
}

void Target::bind_resolved() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, options_.width, options_.height);
}

void Target::resolve() const {
    if (!sample_framebuffer_.id()) return;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, sample_framebuffer_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.id());
    glBlitFramebuffer(0, 0, options_.width, options_.height, 0, 0, options_.width, options_.height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

std::vector<float> Target::read(int color) const {
    std::vector<float> pixels(4 * static_cast<size_t>(options_.width) *
                              static_cast<size_t>(options_.height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glReadBuffer(attachment(static_cast<size_t>(color)));
    glReadPixels(0, 0, options_.width, options_.height, GL_RGBA, GL_FLOAT, pixels.data());
    return pixels;
}

Image Target::read_image(int color) const {
    const bool bytes = options_.format == PixelFormat::rgba8;
    Image image =
        make_image(static_cast<uint32_t>(options_.width), static_cast<uint32_t>(options_.height), 4,
                   bytes ? PixelType::u8 : PixelType::float32);
    image.data = read(color);
    return image;
}

}  // namespace wrinkle::gpu

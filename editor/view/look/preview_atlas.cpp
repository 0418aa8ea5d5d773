#include "editor/view/look/preview_atlas.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "editor/view/look/thumbnails.h"

namespace wrinkle::editor {
namespace {

constexpr uint32_t columns = 8;

}  // namespace

void PreviewAtlas::fill(std::span<const uint8_t> texels, uint32_t width, uint32_t height) {
    count_ = 0;
    if (!gl_) return;
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    const size_t bytes = size_t{4} * width * height;
    const uint32_t most = columns * static_cast<uint32_t>(limit) / height;
    count_ = std::min(static_cast<uint32_t>(texels.size() / bytes), most);
    rows_ = std::max((count_ + columns - 1) / columns, 1U);
    const auto w = static_cast<GLsizei>(width), h = static_cast<GLsizei>(height);
    allocate_texture(texture_, w * static_cast<GLsizei>(columns), h * static_cast<GLsizei>(rows_),
                     nullptr);
    glBindTexture(GL_TEXTURE_2D, texture_);
    for (uint32_t i = 0; i < count_; ++i)
        glTexSubImage2D(GL_TEXTURE_2D, 0, w * static_cast<GLint>(i % columns),
                        h * static_cast<GLint>(i / columns), w, h, GL_RGBA, GL_UNSIGNED_BYTE,
                        texels.data() + i * bytes);
    glBindTexture(GL_TEXTURE_2D, 0);
}

PreviewAtlas::Place PreviewAtlas::place(uint32_t index) const {
    const float u = 1.0F / columns, v = 1.0F / static_cast<float>(rows_);
    const auto x = static_cast<float>(index % columns), y = static_cast<float>(index / columns);
    return {x * u, y * v, (x + 1) * u, (y + 1) * v};
}

}  // namespace wrinkle::editor

#include "editor/view/look/thumbnails.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <vector>

#include "image/load.h"

namespace wrinkle::editor {
namespace {

constexpr uint64_t most_pixels = uint64_t{4} << 20;  // larger files would stall the frame

// Returns every `step`-th texel as 8-bit RGBA.
std::vector<uint8_t> reduced(const Image& image, uint32_t step, uint32_t width, uint32_t height) {
    std::vector<uint8_t> bytes;
    bytes.reserve(size_t{width} * height * 4);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            for (const float value :
                 expand_texel(image.texel(x * step, y * step), image.channels, image.has_alpha))
                bytes.push_back(static_cast<uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255));
    return bytes;
}

uint32_t texture_of(const std::filesystem::path& file) {
    Diagnostics problems;
    const ImageLimits limits = image_limits_from_environment(problems);
    const auto info = read_image_info(file, limits, problems);
    if (!info || uint64_t{info->width} * info->height > most_pixels) return 0;
    const auto image = load_image(file, limits, problems);
    if (!image) return 0;
    const uint32_t longest = std::max(image->width, image->height);
    const uint32_t step = std::max((longest + Thumbnails::side - 1) / Thumbnails::side, 1U);
    const uint32_t width = std::max(image->width / step, 1U);
    const uint32_t height = std::max(image->height / step, 1U);
    const auto bytes = reduced(*image, step, width, height);
    uint32_t texture = 0;
    allocate_texture(texture, static_cast<int>(width), static_cast<int>(height), bytes.data());
    return texture;
}

}  // namespace

void allocate_texture(uint32_t& texture, int width, int height, const uint8_t* texels) {
    if (!texture) glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glBindTexture(GL_TEXTURE_2D, 0);
}

uint32_t Thumbnails::of(const std::filesystem::path& file) {
    if (!gl_) return 0;
    const auto found = textures_.find(file);
    const bool stale = found != textures_.end() && stale_.contains(file);
    if (found != textures_.end() && !stale) return found->second;
    waiting_ |= read_one_;
    if (read_one_) return stale ? found->second : 0;
    read_one_ = true;
    stale_.erase(file);
    if (stale && found->second) glDeleteTextures(1, &found->second);
    return textures_[file] = texture_of(file);
}

// Compares by file, because `file` may be cached under another path.
void Thumbnails::forget(const std::filesystem::path& file) {
    std::error_code error;
    for (const auto& [known, texture] : textures_)
        if (known == file || std::filesystem::equivalent(known, file, error)) stale_.insert(known);
}

}  // namespace wrinkle::editor

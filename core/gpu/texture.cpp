#include "gpu/texture.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace wrinkle::gpu {
namespace {

template <typename T, typename Convert>
std::vector<T> rgba_of(const Image& image, Convert convert) {
    const size_t texels = static_cast<size_t>(image.width) * image.height;
    std::vector<T> result(4 * texels);
    for (size_t i = 0; i < texels; ++i) {
        const float* values = image.data.data() + i * image.channels;
        const auto rgba = expand_texel(values, image.channels, image.has_alpha);
        std::transform(rgba.begin(), rgba.end(), result.data() + 4 * i, convert);
    }
    return result;
}

uint16_t to_u16(float value) {
    return static_cast<uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 65535.0F));
}

enum class Storage { one_float, rgba_u16, rgba_float };

Storage storage_of(const Image& image) {
    if (image.channels == 1) return Storage::one_float;
    return image.source == PixelType::u8 ? Storage::rgba_u16 : Storage::rgba_float;
}

void upload_level(const Image& image, GLint level, Storage storage) {
    const auto put = [&](GLint inside, GLenum format, GLenum type, const void* texels) {
        glTexImage2D(GL_TEXTURE_2D, level, inside, static_cast<GLsizei>(image.width),
                     static_cast<GLsizei>(image.height), 0, format, type, texels);
    };
    switch (storage) {
        case Storage::one_float:
            return put(GL_R32F, GL_RED, GL_FLOAT, image.data.data());
        case Storage::rgba_u16:
            return put(GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT,
                       rgba_of<uint16_t>(image, to_u16).data());
        case Storage::rgba_float:
            return put(GL_RGBA32F, GL_RGBA, GL_FLOAT,
                       rgba_of<float>(image, [](float v) { return v; }).data());
    }
}

// One channel is sampled as (r, r, r, 1), as in expand_texel().
void spread_grey() {
    constexpr std::array<GLint, 4> swizzle{GL_RED, GL_RED, GL_RED, GL_ONE};
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, swizzle.data());
}

GLint wrap_mode(Wrap wrap) {
    constexpr std::array<GLint, 3> modes{GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT};
    return modes[static_cast<size_t>(wrap)];
}

}  // namespace

Texture::Texture() {
    bind(0);
}

Texture Texture::upload(const MipChain& chain) {
    if (chain.levels.empty()) return of_floats(1, 1, std::array<float, 4>{0, 0, 0, 1});
    Texture texture;
    const Storage storage = storage_of(chain.levels.front());
    for (uint32_t level = 0; level < chain.count(); ++level)
        upload_level(chain.levels[level], static_cast<GLint>(level), storage);
    if (storage == Storage::one_float) spread_grey();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(chain.count()) - 1);
    return texture;
}

Texture Texture::of_floats(int width, int height, std::span<const float> rgba) {
    Texture texture;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, rgba.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

void Texture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, handle_.id());
}

Sampler::Sampler(Wrap wrap, Filter filter) {
    const GLuint id = handle_.id();
    const bool linear = filter == Filter::linear;
    glSamplerParameteri(id, GL_TEXTURE_WRAP_S, wrap_mode(wrap));
    glSamplerParameteri(id, GL_TEXTURE_WRAP_T, wrap_mode(wrap));
    glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, linear ? GL_LINEAR : GL_NEAREST);
    glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER,
                        linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST);
}

void Sampler::bind(int unit) const {
    glBindSampler(static_cast<GLuint>(unit), handle_.id());
}

}  // namespace wrinkle::gpu

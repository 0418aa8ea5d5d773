// Writes the textures of the sample graphs, 16-bit PNG files, into the folder it is given:
//
//   make_textures FOLDER
//
//   *_height.png  one channel, 0 to 1; the samples give it its depth
//   *_normal.png  tangent space, green = +v, for the depth (in tiles) that the table below states
//   *_slopes.png  dh/du and dh/dv, 0.5 is flat, for the depth that the table below states
//   *_moments.png the squares of those slopes and their product; 0.5 is 0
//   *_object.png  object space, 2t - 1 = x, y, z
//   *_cube.png    the same in six faces, +x -x +y -y +z -z
//   *_mask.png    one channel, 0 to 1
//
// Every value comes from integer hashes and correctly rounded arithmetic: the files in the
// repository are what this program makes anywhere (a test compares them).

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>

#include "base/diagnostics.h"
#include "image/image.h"
#include "image/load.h"
#include "patterns.h"
#include "sphere.h"

namespace wrinkle::textures {
namespace {

using Pattern = Dual (*)(Dual u, Dual v);

// The middle of texel (x, y), with the derivatives of u and v themselves.
Dual at_texel(const Image& image, Pattern pattern, uint32_t x, uint32_t y) {
    return pattern({(x + 0.5) / image.width, 1, 0}, {(y + 0.5) / image.height, 0, 1});
}

void put_normal(float* texel, const Vector& direction) {
    const auto [x, y, z] = direction;
    const double length = std::sqrt(x * x + y * y + z * z);
    for (size_t i = 0; i < 3; ++i)
        texel[i] = static_cast<float>(0.5 + 0.5 * (direction[i] / length));
}

Image height_map(Pattern pattern, uint32_t size) {
    Image image = make_image(size, size, 1, PixelType::u16);
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x)
            *image.texel(x, y) = static_cast<float>(at_texel(image, pattern, x, y).value);
    return image;
}

Image normal_map(Pattern pattern, double depth, uint32_t size) {
    Image image = make_image(size, size, 3, PixelType::u16);
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const Dual height = at_texel(image, pattern, x, y);
            put_normal(image.texel(x, y), {-depth * height.du, -depth * height.dv, 1});
        }
    return image;
}

Image derivative_map(Pattern pattern, double depth, uint32_t size) {
    Image image = make_image(size, size, 3, PixelType::u16);
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const Dual height = at_texel(image, pattern, x, y);
            float* texel = image.texel(x, y);
            texel[0] = static_cast<float>(0.5 + 0.5 * depth * height.du);
            texel[1] = static_cast<float>(0.5 + 0.5 * depth * height.dv);
        }
    return image;
}

// Of the slopes of derivative_map().
Image moments_map(Pattern pattern, double depth, uint32_t size) {
    Image image = make_image(size, size, 3, PixelType::u16);
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const Dual height = at_texel(image, pattern, x, y);
            const double du = depth * height.du, dv = depth * height.dv;
            float* texel = image.texel(x, y);
            texel[0] = static_cast<float>(0.5 + 0.5 * (du * du));
            texel[1] = static_cast<float>(0.5 + 0.5 * (dv * dv));
            texel[2] = static_cast<float>(0.5 + 0.5 * (du * dv));
        }
    return image;
}

Image object_normal_map(uint32_t width) {
    Image image = make_image(width, width / 2, 3, PixelType::u16);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const Vector point = sphere_point((x + 0.5) / width, (y + 0.5) / image.height);
            put_normal(image.texel(x, y), ball_normal(point));
        }
    return image;
}

// The same ball, in the faces of a cube map: +x -x +y -y +z -z from left to right, each as seen from
// outside. The six faces: where the middle is, and where right and up are.
Image cube_normal_map(uint32_t size) {
    constexpr Vector faces[6][3] = {
        {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
        {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
        {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}};
    Image image = make_image(6 * size, size, 3, PixelType::u16);
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const auto& [middle, right, up] = faces[x / size];
            const double u = 2 * (x % size + 0.5) / size - 1, v = 2 * (y + 0.5) / size - 1;
            const double length = std::sqrt(1 + u * u + v * v);
            Vector point;
            for (size_t i = 0; i < 3; ++i)
                point[i] = (middle[i] + u * right[i] + v * up[i]) / length;
            put_normal(image.texel(x, y), ball_normal(point));
        }
    return image;
}

struct Texture {
    const char* name;
    std::function<Image()> make;
};

bool write_all(const std::filesystem::path& folder) {
    const std::array textures = {
        Texture{"bricks_height.png", [] { return height_map(bricks, 512); }},
        Texture{"weave_height.png", [] { return height_map(weave, 256); }},
        Texture{"weave_normal.png", [] { return normal_map(weave, 0.04, 256); }},
        Texture{"rivets_normal.png", [] { return normal_map(rivets, 0.1, 256); }},
        Texture{"pebbles_height.png", [] { return height_map(pebbles, 256); }},
        Texture{"pebbles_slopes.png", [] { return derivative_map(pebbles, 0.02, 256); }},
        Texture{"pebbles_moments.png", [] { return moments_map(pebbles, 0.02, 256); }},
        Texture{"patches_mask.png", [] { return height_map(patches, 256); }},
        Texture{"ball_object.png", [] { return object_normal_map(512); }},
        Texture{"ball_cube.png", [] { return cube_normal_map(128); }},
    };
    Diagnostics diagnostics;
    for (const Texture& texture : textures)
        save_image(texture.make(), folder / texture.name, {.type = PixelType::u16}, diagnostics);
    std::fputs(to_text(diagnostics).c_str(), stderr);
    return !diagnostics.has_errors();
}

}  // namespace
}  // namespace wrinkle::textures

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: make_textures FOLDER\n", stderr);
        return 2;
    }
    return wrinkle::textures::write_all(arguments[1]) ? 0 : 3;
}

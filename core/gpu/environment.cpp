#include "gpu/environment.h"

#include <epoxy/gl.h>

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

namespace wrinkle::gpu {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double pi = std::numbers::pi;

dvec3 texel(const Image& image, int64_t x, int64_t y) {
    const auto width = static_cast<int64_t>(image.width),
               height = static_cast<int64_t>(image.height);
    const float* values = image.texel(static_cast<uint32_t>((x % width + width) % width),
                                      static_cast<uint32_t>(std::clamp<int64_t>(y, 0, height - 1)));
    return {values[0], values[1], values[2]};
}

dvec3 bilinear(const Image& image, dvec2 uv) {
    const dvec2 at = uv * dvec2(image.width, image.height) - 0.5;
    const dvec2 low = glm::floor(at);
    const auto x = static_cast<int64_t>(low.x), y = static_cast<int64_t>(low.y);
    const dvec2 f = at - low;
    return glm::mix(glm::mix(texel(image, x, y), texel(image, x + 1, y), f.x),
                    glm::mix(texel(image, x, y + 1), texel(image, x + 1, y + 1), f.x), f.y);
}

// `solid_angle` is that of the sample, in steradians.
dvec3 lookup(const MipChain& chain, dvec3 direction, double solid_angle) {
    const double height = chain.levels[0].height;
    const double level = std::log2(std::sqrt(solid_angle) * height / pi);
    const int last = static_cast<int>(chain.count()) - 1;
    const auto nearest =
        static_cast<size_t>(std::clamp(static_cast<int>(std::lround(level)), 0, last));
    return bilinear(chain.levels[nearest], equirect_uv(direction));
}

// Hammersley points: evenly distributed, and the same for every texel.
dvec2 point(int i, int samples) {
    double inverse = 0;
    for (int bit = 0; bit < 8; ++bit)
        if (i >> bit & 1) inverse += 0.5 / (1 << bit);
    return {(i + 0.5) / samples, inverse + 0.5 / samples};
}

struct Lobe {
    dvec3 direction;  // around +z
    double weight;
    double solid_angle;
};

// Light directions reflected at sampled GGX half vectors, weighted by Smith's masking.
std::vector<Lobe> ggx_lobe(double roughness, int samples) {
    const double a2 = std::pow(roughness, 4);
    std::vector<Lobe> lobe;
    for (int i = 0; i < samples; ++i) {
        const dvec2 xi = point(i, samples);
        const double cosine = std::sqrt((1 - xi.x) / (1 + (a2 - 1) * xi.x));
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        const dvec3 half(sine * std::cos(2 * pi * xi.y), sine * std::sin(2 * pi * xi.y), cosine);
        const dvec3 light = 2 * cosine * half - dvec3(0, 0, 1);
        if (light.z <= 0) continue;
        const double facet = cosine * cosine * (a2 - 1) + 1;
        const double density = a2 / (pi * facet * facet) / 4;
        const double slope2 = 1 / (light.z * light.z) - 1;
        lobe.push_back({light, 2 / (1 + std::sqrt(1 + a2 * slope2)), 1 / (samples * density)});
    }
    return lobe;
}

dvec3 gather(const MipChain& chain, dvec3 normal, const std::vector<Lobe>& lobe) {
    const dvec3 axis = std::abs(normal.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
    const dvec3 t = glm::normalize(glm::cross(axis, normal));
    const dvec3 b = glm::cross(normal, t);
    dvec3 sum(0);
    double weights = 0;
    for (const Lobe& each : lobe) {
        const dvec3 d = each.direction.x * t + each.direction.y * b + each.direction.z * normal;
        sum += each.weight * lookup(chain, d, each.solid_angle);
        weights += each.weight;
    }
    return sum / weights;
}

// Calls of(direction) for the centre of each texel.
template <typename F>
CubeFaces faces_of(int side, F of) {
    CubeFaces faces;
    for (auto& texels : faces)
        texels.resize(static_cast<size_t>(side) * static_cast<size_t>(side));
    tbb::parallel_for(0, 6 * side, [&](int row) {
        const int face = row / side, y = row % side;
        for (int x = 0; x < side; ++x) {
            const dvec2 st = (dvec2(x, y) + 0.5) / static_cast<double>(side);
            faces[static_cast<size_t>(face)][static_cast<size_t>(y * side + x)] =
                of(cube_direction(face, st));
        }
    });
    return faces;
}

// The radiance of a grid of directions, with their solid angles.
struct Light {
    dvec3 direction, radiance;
    double solid_angle;
};
std::vector<Light> lights_of(const MipChain& chain) {
    constexpr int columns = 64, rows = 32;
    constexpr double step = pi / rows;
    std::vector<Light> lights;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const double elevation = (y + 0.5) * step - pi / 2, turn = (x + 0.5) * step;
            const double across = std::cos(elevation);
            const dvec3 d(across * std::sin(turn), std::sin(elevation), across * std::cos(turn));
            lights.push_back({d, lookup(chain, d, step * step), across * step * step});
        }
    return lights;
}

// Cosine-weighted means: a sum over all directions, since a few samples would miss small lights.
CubeFaces irradiance_of(const MipChain& chain) {
    const std::vector<Light> lights = lights_of(chain);
    return faces_of(irradiance_side, [&](dvec3 normal) {
        dvec3 sum(0);
        double weights = 0;
        for (const Light& light : lights) {
            const double weight =
                std::max(glm::dot(light.direction, normal), 0.0) * light.solid_angle;
            sum += weight * light.radiance;
            weights += weight;
        }
        return sum / weights;
    });
}

// Uploads to the cube map that is bound.
void upload(const CubeFaces& faces, int level, int side) {
    for (size_t face = 0; face < faces.size(); ++face)
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), level, GL_RGB32F,
                     side, side, 0, GL_RGB, GL_FLOAT, faces[face].data());
}

void set_filter(int last_level) {
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, last_level);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

}  // namespace

dvec3 cube_direction(int face, dvec2 st) {
    const double s = 2 * st.x - 1, t = 2 * st.y - 1;
    const std::array<dvec3, 6> directions{dvec3(1, -t, -s), dvec3(-1, -t, s), dvec3(s, 1, t),
                                          dvec3(s, -1, -t), dvec3(s, -t, 1),  dvec3(-s, -t, -1)};
    return glm::normalize(directions.at(static_cast<size_t>(face)));
}

dvec2 equirect_uv(dvec3 d) {
    return {0.5 + std::atan2(d.x, -d.z) / (2 * pi),
            0.5 + std::asin(std::clamp(d.y, -1.0, 1.0)) / pi};
}

MipChain radiance_of(const Image& image) {
    Image clean = make_image(image.width, image.height, 3);
    for (size_t i = 0; i < size_t{image.width} * image.height; ++i) {
        const auto texel =
            expand_texel(&image.data[i * image.channels], image.channels, image.has_alpha);
        for (size_t k = 0; k < 3; ++k)
            clean.data[3 * i + k] =
                std::isfinite(texel[k]) ? std::clamp(texel[k], 0.0F, 65504.0F) : 0;
    }
    return build_mips(std::move(clean));
}

double roughness_of_level(int level) {
    return std::pow(level / (environment_levels - 1.0), 1.5);
}

EnvironmentCube prefilter(const Image& image) {
    constexpr std::array<int, environment_levels> samples{1, 16, 32, 64, 128, 256, 256, 256};
    const MipChain chain = radiance_of(image);
    EnvironmentCube cube;
    for (int level = 0; level < environment_levels; ++level) {
        const int side = environment_side >> level;
        const double texel = 4 * pi / (6.0 * side * side);
        const auto lobe =
            level == 0 ? std::vector<Lobe>{{{0, 0, 1}, 1, texel}}
                       : ggx_lobe(roughness_of_level(level), samples[static_cast<size_t>(level)]);
        cube.reflections[static_cast<size_t>(level)] =
            faces_of(side, [&](dvec3 normal) { return gather(chain, normal, lobe); });
    }
    cube.irradiance = irradiance_of(chain);
    return cube;
}

EnvironmentTexture::EnvironmentTexture(const EnvironmentCube& cube) {
    bind(0, 0);
    upload(cube.irradiance, 0, irradiance_side);
    set_filter(0);
    glBindTexture(GL_TEXTURE_CUBE_MAP, reflections_.id());
    for (int level = 0; level < environment_levels; ++level)
        upload(cube.reflections[static_cast<size_t>(level)], level, environment_side >> level);
    set_filter(environment_levels - 1);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

void EnvironmentTexture::bind(int reflections_unit, int irradiance_unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(reflections_unit));
    glBindTexture(GL_TEXTURE_CUBE_MAP, reflections_.id());
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(irradiance_unit));
    glBindTexture(GL_TEXTURE_CUBE_MAP, irradiance_.id());
}

}  // namespace wrinkle::gpu

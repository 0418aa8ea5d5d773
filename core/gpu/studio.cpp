#include "gpu/studio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <vector>

namespace wrinkle::gpu {
namespace {

using glm::vec3;

constexpr std::array<std::string_view, 5> names{"studio", "overcast", "contrast", "sun", "furnace"};

// A rounded rectangle in the plane at right angles to its direction; angles in degrees.
struct Softbox {
    float azimuth, elevation;  // azimuth from +z towards +x
    float width, height, soft, roll;
    float radiance;
    vec3 color;
};

// Radiance by direction.y: `low` at low_y to `high` at high_y.
struct Slope {
    vec3 low, high;
    float low_y, high_y;

    vec3 at(float y) const { return glm::mix(low, high, glm::smoothstep(low_y, high_y, y)); }
};

struct Room {
    Slope above, below;
    std::vector<Softbox> lights;
    float level = 1;  // factor on all radiance
};

const vec3 white(1);

constexpr Softbox key{-42, key_elevation, 40, 40, 4, 0, 9, {1, 0.97F, 0.93F}};

vec3 unit(float azimuth, float elevation) {
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
            std::cos(elevation) * std::cos(azimuth)};
}

Room room_of(Mood mood) {
    const Slope gray{{0.40F, 0.405F, 0.415F}, {0.05F, 0.053F, 0.06F}, -0.05F, 0.75F};
    const Slope floor{{0.07F, 0.067F, 0.065F}, {0.30F, 0.292F, 0.285F}, -0.9F, 0};
    const Softbox rim_right{150, 28, 16, 74, 4, 12, 10, white};
    const Softbox rim_left{-122, 16, 12, 64, 4, -8, 4.5F, {0.92F, 0.96F, 1}};
    switch (mood) {
        case Mood::studio:
            return {gray,
                    floor,
                    {key,
                     {68, 10, 56, 64, 16, 0, 0.9F, {0.90F, 0.95F, 1}},
                     rim_right,
                     rim_left,
                     {0, 82, 64, 32, 10, 0, 1.8F, white}},
                    0.78F};
        case Mood::overcast:
            return {{{0.5F, 0.5F, 0.52F}, {1.05F, 1.07F, 1.1F}, -0.05F, 0.9F},
                    {{0.16F, 0.155F, 0.15F}, {0.34F, 0.33F, 0.32F}, -0.9F, 0},
                    {}};
        case Mood::contrast:
            return {{{0.10F, 0.101F, 0.104F}, {0.012F, 0.013F, 0.015F}, -0.05F, 0.75F},
                    {{0.02F, 0.02F, 0.02F}, {0.07F, 0.07F, 0.07F}, -0.9F, 0},
                    {{-70, 20, 24, 24, 3, 0, 14, white}, rim_right, rim_left}};
        case Mood::sun:
            return {{{0.55F, 0.62F, 0.72F}, {0.13F, 0.22F, 0.42F}, -0.05F, 0.8F},
                    {{0.10F, 0.09F, 0.08F}, {0.24F, 0.22F, 0.19F}, -0.9F, 0},
                    {},
                    0.6F};
        case Mood::furnace:
            break;
    }
    return {{white, white, 0, 1}, {white, white, -1, 0}, {}};
}

// Returns the fraction of the box's radiance in a direction.
float seen(const Softbox& box, vec3 direction) {
    const float azimuth = glm::radians(box.azimuth), elevation = glm::radians(box.elevation);
    const vec3 middle = unit(azimuth, elevation);
    const float depth = glm::dot(direction, middle);
    if (depth <= 0) return 0;
    const vec3 level(std::cos(azimuth), 0, -std::sin(azimuth));
    const vec3 steep = glm::cross(middle, level);
    const float roll = glm::radians(box.roll);
    const vec3 right = std::cos(roll) * level + std::sin(roll) * steep;
    const vec3 up = std::cos(roll) * steep - std::sin(roll) * level;
    const glm::vec2 half = glm::tan(glm::radians(glm::vec2(box.width, box.height)) / 2.0F);
    const glm::vec2 p = glm::vec2(glm::dot(direction, right), glm::dot(direction, up)) / depth;
    const float corner = 0.3F * std::min(half.x, half.y);
    const glm::vec2 q = glm::abs(p) - half + corner;
    const float edge =
        glm::length(glm::max(q, glm::vec2(0))) + std::min(std::max(q.x, q.y), 0.0F) - corner;
    const glm::vec2 inside = p / half;
    const float middle_to_edge = 1 - 0.35F * std::min(1.0F, 0.5F * glm::dot(inside, inside));
    return middle_to_edge * (1 - glm::smoothstep(-std::tan(glm::radians(box.soft)), 0.0F, edge));
}

vec3 radiance(const Room& room, vec3 direction) {
    const float horizon = glm::smoothstep(-0.03F, 0.03F, direction.y);
    vec3 sum = glm::mix(room.below.at(direction.y), room.above.at(direction.y), horizon);
    for (const Softbox& box : room.lights)
        sum += seen(box, direction) * box.radiance * box.color;
    return sum * room.level;
}

}  // namespace

std::span<const std::string_view> mood_names() {
    return names;
}

std::optional<Mood> mood_named(std::string_view name) {
    const auto* found = std::ranges::find(names, name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Mood>(found - names.begin());
}

Image environment_of(Mood mood) {
    constexpr uint32_t width = 512, height = 256;
    constexpr float pi = std::numbers::pi_v<float>;
    const Room room = room_of(mood);
    Image image = make_image(width, height, 3);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const float elevation = ((static_cast<float>(y) + 0.5F) / height - 0.5F) * pi;
            const float turn = ((static_cast<float>(x) + 0.5F) / width - 0.5F) * 2 * pi;
            const float flat = std::cos(elevation);
            const vec3 value = radiance(
                room, {flat * std::sin(turn), std::sin(elevation), -flat * std::cos(turn)});
            for (int k = 0; k < 3; ++k)
                image.texel(x, y)[k] = value[k];
        }
    return image;
}

float directional_light_of(Mood mood) {
    return mood == Mood::sun ? 0.8F : 0;
}

glm::vec3 light_direction(float turn) {
    return light_direction(turn, glm::radians(key_elevation));
}

glm::vec3 light_direction(float turn, float elevation) {
    return unit(glm::radians(key.azimuth) + turn, elevation);
}

}  // namespace wrinkle::gpu

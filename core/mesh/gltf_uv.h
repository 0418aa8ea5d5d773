// KHR_texture_transform: uv transforms that a material applies to the uv sets of a primitive.
#pragma once

#include <tiny_gltf.h>

#include <array>
#include <optional>

#include "mesh/mesh.h"

namespace wrinkle {

// uv' = offset + R(rotation) (scale uv) in glTF's coordinates, v downwards. R rotates by
// (cos, sin; -sin, cos), which is counter-clockwise on screen.
struct UvTransform {
    glm::dvec2 offset{0};
    glm::dvec2 scale{1};
    double rotation = 0;

    glm::vec2 apply(glm::vec2 uv) const;
    bool keeps_tangents() const { return rotation == 0 && scale.x > 0 && scale.y > 0; }
    friend bool operator==(const UvTransform&, const UvTransform&) = default;
};

struct UvTransforms {
    std::array<std::optional<UvTransform>, max_uv_sets> sets;
    bool differ = false;  // two textures transform one set differently; the first one is used
};

UvTransforms uv_transforms(const tinygltf::Model& model, int material);

}  // namespace wrinkle

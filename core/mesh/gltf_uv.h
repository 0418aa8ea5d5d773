// KHR_texture_transform: which uv sets of a primitive a material moves, and how.
#pragma once

#include <tiny_gltf.h>

#include <array>
#include <optional>

#include "mesh/mesh.h"

namespace wrinkle {

// uv' = offset + R(rotation) (scale uv) in glTF's coordinates, v downwards; R turns by
// (cos, sin; -sin, cos), which is counter-clockwise as one sees it.
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
    bool differ = false;  // two textures want one set in two ways; the first of them has it
};

UvTransforms uv_transforms(const tinygltf::Model& model, int material);

}  // namespace wrinkle

// Vertex welding and safe normalisation, shared by normals, tangents and displacement.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "mesh/mesh.h"

namespace wrinkle {

// Hash of the bytes of a std::array of numbers.
template <typename Array>
struct ArrayHash {
    size_t operator()(const Array& key) const {
        const auto* bytes = reinterpret_cast<const char*>(key.data());
        return std::hash<std::string_view>()({bytes, key.size() * sizeof key[0]});
    }
};

// Returns, for each vertex, the first one with the same position, or with the same position, normal
// and uv0. Values compare as numbers: -0 equals 0, and NaN equals nothing.
std::vector<uint32_t> weld_positions(const Mesh& mesh);
std::vector<uint32_t> weld_frames(const Mesh& mesh);  // precondition: the mesh has normals and uv0

// Returns the unit vector, or zero if v is zero or not finite. Lengths do not under- or overflow.
glm::dvec3 unit_or_zero(glm::dvec3 v);

}  // namespace wrinkle

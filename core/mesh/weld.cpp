#include "mesh/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace wrinkle {
namespace {

template <size_t N, typename KeyOf>
std::vector<uint32_t> weld(size_t count, KeyOf key_of) {
    using Key = std::array<float, N>;
    std::unordered_map<Key, uint32_t, ArrayHash<Key>> first;
    first.reserve(count);
    std::vector<uint32_t> result(count);
    for (uint32_t v = 0; v < count; ++v) {
        Key key = key_of(v);
        bool is_number = true;
        for (float& value : key) {
            is_number = is_number && !std::isnan(value);
            value += 0.0F;  // -0 becomes 0
        }
        result[v] = is_number ? first.try_emplace(key, v).first->second : v;
    }
    return result;
}

}  // namespace

std::vector<uint32_t> weld_positions(const Mesh& mesh) {
    return weld<3>(mesh.vertex_count(), [&](uint32_t v) {
        const glm::vec3 p = mesh.positions[v];
        return std::array<float, 3>{p.x, p.y, p.z};
    });
}

std::vector<uint32_t> weld_frames(const Mesh& mesh) {
    return weld<8>(mesh.vertex_count(), [&](uint32_t v) {
        const glm::vec3 p = mesh.positions[v];
        const glm::vec3 n = mesh.normals[v];
        const glm::vec2 uv = mesh.uvs[0][v];
        return std::array<float, 8>{p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y};
    });
}

glm::dvec3 unit_or_zero(glm::dvec3 v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0) || !std::isfinite(v.x + v.y + v.z)) return glm::dvec3(0);
    const glm::dvec3 scaled = v / largest;
    return scaled / glm::length(scaled);
}

}  // namespace wrinkle

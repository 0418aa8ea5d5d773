#include <algorithm>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "mesh/mesh.h"

namespace wrinkle {
namespace {

glm::vec3 unit(glm::vec3 v) {
    const float length = glm::length(v);
    return length > 0 ? v / length : v;
}

class Pass {
public:
    Pass(Mesh& mesh, float longest) : mesh_(mesh), longest_(longest) {}

    // Splits every long edge once; returns the new index list.
    std::vector<uint32_t> run() {
        const std::vector<uint32_t> old = mesh_.indices;
        for (size_t t = 0; t < old.size(); t += 3)
            triangle({old[t], old[t + 1], old[t + 2]});
        return std::move(indices_);
    }

private:
    using Corners = std::array<uint32_t, 3>;
    static constexpr uint32_t none = ~0U;

    void triangle(const Corners& c) {
        Corners middle{};
        size_t cuts = 0;
        for (size_t k = 0; k < 3; ++k) {
            middle[k] = cut(c[k], c[(k + 1) % 3]);
            cuts += middle[k] != none ? 1 : 0;
        }
        if (cuts == 0) return add(c[0], c[1], c[2]);
        size_t k = 0;  // start of the only split edge, or end of the only unsplit one
        while (cuts == 1 ? middle[k] == none : cuts == 2 && middle[(k + 2) % 3] != none)
            ++k;
        const uint32_t a = c[k], b = c[(k + 1) % 3], d = c[(k + 2) % 3];
        const uint32_t ab = middle[k], bd = middle[(k + 1) % 3], da = middle[(k + 2) % 3];
        if (cuts == 1) {
            add(a, ab, d);
            add(ab, b, d);
        } else if (cuts == 2) {
            add(ab, b, bd);
            add(a, ab, bd);
            add(a, bd, d);
        } else {
            add(a, ab, da);
            add(ab, b, bd);
            add(da, bd, d);
            add(ab, bd, da);
        }
    }

    void add(uint32_t a, uint32_t b, uint32_t c) { indices_.insert(indices_.end(), {a, b, c}); }

    uint32_t cut(uint32_t a, uint32_t b) {
        if (!(glm::distance(mesh_.positions[a], mesh_.positions[b]) > longest_)) return none;
        const uint64_t key = uint64_t{std::min(a, b)} << 32 | std::max(a, b);
        const auto [found, made] =
            middles_.try_emplace(key, static_cast<uint32_t>(mesh_.vertex_count()));
        if (made) add_middle(a, b);
        return found->second;
    }

    void add_middle(uint32_t a, uint32_t b) {
        each_vertex_array(mesh_, [a, b](auto& values) {
            if (!values.empty()) values.push_back((values[a] + values[b]) * 0.5F);
        });
        if (!mesh_.normals.empty()) mesh_.normals.back() = unit(mesh_.normals.back());
        if (!mesh_.tangents.empty()) {
            glm::vec4& tangent = mesh_.tangents.back();
            tangent = glm::vec4(unit(glm::vec3(tangent)), mesh_.tangents[a].w);
        }
    }

    Mesh& mesh_;
    const float longest_;
    std::vector<uint32_t> indices_;
    std::unordered_map<uint64_t, uint32_t> middles_;
};

}  // namespace

Mesh subdivided(Mesh mesh, float longest, size_t max_triangles) {
    if (!(longest > 0)) return mesh;
    while (mesh.triangle_count() * 4 <= max_triangles) {
        const size_t before = mesh.indices.size();
        mesh.indices = Pass(mesh, longest).run();
        if (mesh.indices.size() == before) break;
    }
    return mesh;
}

}  // namespace wrinkle

// Surface points of a mesh by a search through all of its triangles.
#pragma once

#include <numeric>

#include "mesh/sample.h"

namespace wrinkle::test {

inline std::optional<SurfacePoint> sample_surface(const Mesh& mesh, glm::dvec2 uv, uint32_t size) {
    std::vector<uint32_t> all(mesh.triangle_count());
    std::iota(all.begin(), all.end(), 0U);
    return sample_mesh(mesh, all, uv, size);
}

}  // namespace wrinkle::test

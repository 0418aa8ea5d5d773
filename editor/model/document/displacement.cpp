#include "editor/model/document/displacement.h"

#include <glm/geometric.hpp>

#include "bake/displace.h"
#include "mesh/mesh.h"

namespace wrinkle::editor {

std::optional<Mesh> displaced(const Mesh& still, const Displacement& displacement,
                              TextureStore& textures, Diagnostics& problems) {
    constexpr float triangles_across = 150;
    for (const Resource& image : displacement.images)
        if (!textures.read(texels_of(image), problems)) {
            textures.forget();  // to be tried and reported again
            return std::nullopt;
        }
    const Bounds bounds = bounds_of(still);
    Mesh mesh = subdivided(still, glm::distance(bounds.low, bounds.high) / triangles_across);
    const std::string why =
        displace(mesh, displacement.program, 0, textures.textures_of(displacement.images));
    if (why.empty()) return mesh;
    problems.error(RuleId::over_limit, why);
    return std::nullopt;
}

}  // namespace wrinkle::editor

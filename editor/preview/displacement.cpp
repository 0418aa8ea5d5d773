#include "editor/preview/displacement.h"

#include <glm/geometric.hpp>
#include <map>

#include "bake/displace.h"
#include "image/load.h"
#include "mesh/subdivide.h"

namespace wrinkle::editor {

std::optional<Mesh> displaced(const Mesh& still, const Displacement& displacement,
                              Diagnostics& problems) {
    constexpr float triangles_across = 150;
    std::map<std::string, MipChain> chains;
    std::vector<Texture> textures;
    for (const Resource& image : displacement.images) {
        if (!chains.contains(image.file)) {
            auto pixels = load_image(image.file, problems);
            if (!pixels) return std::nullopt;
            chains[image.file] = build_mips(std::move(*pixels));
        }
        textures.emplace_back(chains[image.file], image.options);
    }
    const Bounds bounds = bounds_of(still);
    Mesh mesh = subdivided(still, glm::distance(bounds.low, bounds.high) / triangles_across);
    const std::string why = displace(mesh, displacement.program, 0, textures);
    if (why.empty()) return mesh;
    problems.error(why);
    return std::nullopt;
}

}  // namespace wrinkle::editor

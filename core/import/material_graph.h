// The graph of a material that reads a texture set.
//
// Every channel becomes the standard output of its name. Colors are read as sRGB, but linear from
// float files; data as stored. The normal comes from the normal map, else from the height map.
// Nodes: `tile` (uv_transform), one node for each image (`color_map`, `normal_map`, ...;
// `packed_map` for several channels), and the arithmetic between. Exposed inputs: `tiling`, `bump`
// (factor of the slopes), `roughness` (factor) and `height` (height of white over black); each only
// if it has an effect.
#pragma once

#include <array>
#include <filesystem>
#include <optional>

#include "graph/document.h"
#include "import/texture_set.h"

namespace wrinkle::textures {

// Lengths are in units of object space.
//
//   given      size of a repeat             default of `tiling`
//   texel      texel * size of the image    uv_length / size; without it, width / size
//   uv_length  uv_length                    1
//   neither    1                            1
//
// If one is given, heights are lengths on the surface (scale `surface`); otherwise slopes do not
// depend on the surface (scale `unit`). A height in another channel than red always has `surface`.
struct GraphOptions {
    std::optional<std::array<double, 2>> texel = {};  // width and height of a texel, > 0
    std::optional<double> uv_length = {};             // length of a uv unit on the mesh, > 0
    // Height of white over black. Default: TextureSet::relief times the texel, else default_relief
    // times the width of a repeat.
    std::optional<double> height = {};
    std::filesystem::path folder = {};  // with the graph; images are named relative to it
};
inline constexpr double default_relief = 0.02;

// Precondition: examine_textures() succeeded. Equal arguments give equal documents.
Document material_graph(const TextureSet& set, const GraphOptions& options);

}  // namespace wrinkle::textures

#include "nodes/all.h"

#include <span>
#include <vector>

#include "wrinkle/node.h"

// The files of nodes in the order of the menus and of the reference. Each ends with the list of its
// nodes.
// clang-format off
#define WRINKLE_NODE_FILES(X) \
    X(uv) X(image) X(cube_map) X(triplanar) X(hex) X(decal) X(gradient) X(roughness) X(frame) \
    X(compositor) X(height) X(noise) X(fractal) X(cellular) X(waves) X(periodic) X(pattern) \
    X(weave) X(parallax) X(math) X(vector) X(value) X(ramp) X(color_blend) X(color) X(random) \
    X(uv_tools) X(mask) X(shape) X(figure) X(bricks) X(voronoi) X(scatter) \
    X(material) X(comparison) X(comparison_surface)
// clang-format on

namespace wrinkle {

namespace nodes {
#define X(file) extern std::span<sdk::Node> file##_nodes;
WRINKLE_NODE_FILES(X)
#undef X
}  // namespace nodes

const wr_plugin* built_in_nodes() {
    static const std::vector<const wr_node*> list = [] {
        std::vector<const wr_node*> descriptors;
#define X(file) nodes::file##_nodes,
        for (const auto& file : {WRINKLE_NODE_FILES(X)})
#undef X
            for (sdk::Node& node : file)
                descriptors.push_back(node.descriptor());
        return descriptors;
    }();
    static const wr_plugin plugin{sizeof(wr_plugin),
                                  WR_ABI,
                                  "wrinkle",
                                  "1.0",
                                  list.data(),
                                  static_cast<uint32_t>(list.size()),
                                  [](const char*) -> const void* { return nullptr; }};
    return &plugin;
}

}  // namespace wrinkle

// Node previews: the shown output (request.h) of each node on a flat patch of surface, two units
// wide and one high, seen from the front, with uvs and positions in units.
//
// Values are computed by the CPU evaluator, for all nodes at once: no shader is built, and they are
// equal to those of `wrinkle eval`. Colors are shown by the sRGB curve, vectors unchanged; a
// gradient, a derivative and a normal as the unit normal, 0.5 + 0.5 n; a height and a float as gray
// over the visible range; a vec2 as its fractional part. Values that are not finite are magenta. A
// preview of one color shows the lower left corner of the patch magnified if colors differ there: a
// fine bump, which filters to a flat surface, shows its shape.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cpu/texture_store.h"
#include "editor/model/document/model.h"
#include "editor/model/worker.h"
#include "ir/side_tables.h"

namespace wrinkle::editor {

struct NodePreviewJob {
    uint64_t version = 0;  // increases with every job
    Model model;
    Document document;
    std::set<std::string> nodes;  // nodes to draw
    uint64_t images = 0;          // when it changes, image files are read again
};

struct NodePreviews {
    static constexpr uint32_t width = 128, height = 64;  // texels of one preview
    static constexpr uint32_t magnification = 8;

    uint64_t version = 0;
    std::map<std::string, uint32_t, std::less<>> places;  // preview index in `texels`, by node
    std::set<std::string, std::less<>> magnified;         // nodes
    std::vector<uint8_t> texels;  // RGBA, bottom row first, one preview after the other
};

// Caches the images that it has read.
class NodePainter {
public:
    // Draws no preview of a node that does not compile. Errors of other nodes or of the graph's
    // outputs have no effect.
    NodePreviews operator()(const NodePreviewJob& job);

private:
    // Returns false, and draws nothing, if the nodes do not compile together.
    bool draw_group(const NodePreviewJob& job, const std::vector<std::string>& nodes,
                    NodePreviews& previews);

    // Replaces the previews of those nodes that have several colors when magnified.
    void magnify(const NodePreviewJob& job, const std::vector<std::string>& nodes,
                 NodePreviews& previews);

    uint64_t images_ = 0;
    TextureStore textures_;
};
using NodePreviewMaker = Worker<NodePreviewJob, NodePreviews>;

}  // namespace wrinkle::editor

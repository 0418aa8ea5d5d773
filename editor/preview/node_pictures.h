// What each node makes, as small pictures: its shown output (request.h) on a flat patch of surface,
// two units wide and one high, seen from in front, with uvs and positions in units.
//
// The numbers come from the CPU evaluator, all nodes at once, so no shader is built for them and
// they are those of `wrinkle eval`. Shown as: colours by the curve of sRGB, vectors as they are; a
// gradient, a derivative and a normal as the unit normal, 0.5 + 0.5 n; a height and a float as gray
// over the range that is seen; a point of the plane as its fraction. What is not finite is magenta.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cpu/texture_store.h"
#include "editor/document/model.h"
#include "editor/worker.h"
#include "ir/module.h"

namespace wrinkle::editor {

struct NodePictureJob {
    uint64_t version = 0;  // grows with every job
    const Registry* registry = nullptr;
    Model model;
    Document document;
    std::set<std::string> nodes;  // whose pictures are wanted
    uint64_t images = 0;          // when it changes, image files are read again
};

struct NodePictures {
    static constexpr uint32_t width = 128, height = 64;  // texels of one

    uint64_t version = 0;
    std::map<std::string, uint32_t, std::less<>> places;  // of a node's picture in `texels`
    std::vector<uint8_t> texels;  // RGBA, bottom row first, one picture after the other
};

// Keeps the images that it has read.
class NodePainter {
public:
    // No picture of a node that does not compile. Other nodes that are wrong do not matter, nor do
    // the graph's outputs.
    NodePictures draw(const NodePictureJob& job);

private:
    // False when they do not compile together; nothing is drawn then.
    bool draw_group(const NodePictureJob& job, const std::vector<std::string>& nodes,
                    NodePictures& pictures);

    uint64_t images_ = 0;
    TextureStore textures_;
};

// The same on a thread of its own; the newest job wins.
class NodePictureMaker {
public:
    // wake is called on its thread.
    explicit NodePictureMaker(std::function<void()> wake = {})
        : worker_(
              [painter = NodePainter()](NodePictureJob&& job) mutable { return painter.draw(job); },
              std::move(wake)) {}

    void ask(NodePictureJob job) { worker_.post(std::move(job)); }
    std::optional<NodePictures> take() { return worker_.take(); }
    bool idle() const { return worker_.idle(); }
    void settle() { worker_.settle(); }

private:
    Worker<NodePictureJob, NodePictures> worker_;
};

}  // namespace wrinkle::editor

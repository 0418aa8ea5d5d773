// Small images of graph files: the values of an output over one tile of uv, as the 2D view shows
// them (flat_values.h). A worker draws one at a time, on request.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "editor/model/worker.h"
#include "registry/registry.h"

namespace wrinkle::editor {

struct GraphImageJob {
    std::filesystem::path file = {};
    std::filesystem::path root = {};  // files outside are not read; "": the folder of the file
    const Registry* registry = nullptr;
    std::filesystem::file_time_type written{};
};

struct GraphImage {
    static constexpr uint32_t side = 64;  // texels

    std::filesystem::path file;
    std::filesystem::file_time_type written{};
    std::vector<uint8_t> texels;  // RGBA, bottom row first; empty: nothing can be shown
};

// Shows the output `color`, else `material`, else the first one with values.
GraphImage draw_graph_image(GraphImageJob&& job);

using GraphImageMaker = Worker<GraphImageJob, GraphImage>;

class GraphImages {
public:
    GraphImageMaker* maker = nullptr;  // nullptr: no images
    bool gl = false;                   // textures can be made

    // Returns the texture; 0 if there is none or it is not drawn yet: call again. One of a file
    // that was changed is drawn again.
    uint32_t of(GraphImageJob wanted);
    void take();                       // takes a finished image, once a frame
    void forget() { drawn_.clear(); }  // after the GL context was lost
    bool idle() const { return !maker || maker->idle(); }

private:
    struct Drawn {
        std::filesystem::file_time_type written;
        uint32_t texture = 0;
    };
    std::map<std::filesystem::path, Drawn> drawn_;
};

}  // namespace wrinkle::editor

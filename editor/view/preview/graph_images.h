// Small images of graph files and of presets: the values of an output over one tile of uv, as the
// 2D view shows them (flat_values.h). A worker draws one at a time, on request.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "editor/model/document/model.h"
#include "editor/model/worker.h"
#include "graph/document.h"

namespace wrinkle::editor {

struct GraphFile {
    std::filesystem::path file;
    std::filesystem::path root;  // files outside are not read; "": the folder of the file
    const Registry* registry = nullptr;
};

// The open graph with the inputs of a preset; "": the defaults.
struct GraphPreset {
    Model model;
    Document document;
    std::string preset;
};

struct GraphImageJob {
    std::string key;     // of the image: "preset Wet", or the path of the file
    uint64_t stamp = 0;  // an image with another stamp is drawn again
    std::variant<GraphFile, GraphPreset> graph;
};

struct GraphImage {
    static constexpr uint32_t side = 64;  // texels

    std::string key;
    uint64_t stamp = 0;
    std::vector<uint8_t> texels;  // RGBA, bottom row first; empty: nothing can be shown
};

// Shows the output `color`, else `material`, else the first one with values.
GraphImage draw_graph_image(GraphImageJob&& job);

using GraphImageMaker = Worker<GraphImageJob, GraphImage>;

class GraphImages {
public:
    GraphImageMaker* maker = nullptr;  // nullptr: no images
    bool gl = false;                   // textures can be made

    // Return the texture; 0 if there is none or it is not drawn yet: call again. That of a file or
    // a document that was changed is drawn again.
    uint32_t of(const GraphFile& file);
    uint32_t of(const GraphPreset& preset, uint64_t version);  // of the document
    void take();                       // takes a finished image, once a frame
    void forget() { drawn_.clear(); }  // after the GL context was lost
    bool idle() const { return !maker || maker->idle(); }

private:
    uint32_t find_or_draw(GraphImageJob job);

    struct Drawn {
        uint64_t stamp = 0;
        uint32_t texture = 0;
    };
    std::map<std::string, Drawn> drawn_;  // by key
};

}  // namespace wrinkle::editor

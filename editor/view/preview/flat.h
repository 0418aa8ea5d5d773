// The 2D view: the shown output (request.h) of one node over a rectangle of uv, with its values.
#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "editor/model/worker.h"
#include "editor/view/preview/flat_values.h"

namespace wrinkle::editor {

struct State;

// Rectangle of uv that is shown, and how values become colors.
struct FlatView {
    bool on = false;          // instead of the object
    double u = 0.5, v = 0.5;  // middle
    double span = 1.1;        // uv units of the shorter side
    int channel = -1;         // -1: all; else one lane, as gray
    bool fits_range = true;   // gray over the visible range; else from 0 to 1
    std::string output = {};  // shown channel of materials; "": the color
    bool operator==(const FlatView&) const = default;
};

struct FlatJob {
    uint64_t version = 0;  // increases with every job
    Model model;
    Document document;
    std::string node;
    FlatArea area;
    int channel = -1;
    bool fits_range = true;
    std::string output;   // as in FlatView
    std::string preset;   // preset of the inputs; "": the defaults
    uint64_t images = 0;  // when it changes, image files are read again
};

struct FlatImage {
    static constexpr size_t bins = 64;

    uint64_t version = 0;  // 0: none
    FlatArea area;
    FlatValues values;  // `node` is "" if the node does not compile, or makes nothing to show
    Range range;        // range of the finite values of the shown lanes
    double mean = 0;    // their mean
    std::array<uint32_t, bins> histogram{};
    std::vector<uint8_t> texels;  // RGBA, bottom row first
};

// Caches the images that it has read.
class FlatPainter {
public:
    FlatImage operator()(const FlatJob& job);

private:
    uint64_t images_ = 0;
    TextureStore textures_;
};
using FlatMaker = Worker<FlatJob, FlatImage>;

// Screen pixels of the view, and the uv rectangle that they show.
struct FlatPanel {
    ImVec2 at{0, 0}, end{0, 0};
    FlatArea shown;

    bool contains(ImVec2 point) const {
        return point.x >= at.x && point.y >= at.y && point.x < end.x && point.y < end.y;
    }
    // uv units of a pixel.
    double pixel() const { return shown.texel * shown.width / static_cast<double>(end.x - at.x); }
    double u_at(float x) const { return shown.u + static_cast<double>(x - at.x) * pixel(); }
    double v_at(float y) const { return shown.v + static_cast<double>(end.y - y) * pixel(); }
    float x_of(double u) const { return at.x + static_cast<float>((u - shown.u) / pixel()); }
    float y_of(double v) const { return end.y - static_cast<float>((v - shown.v) / pixel()); }
};

struct FlatFeed {
    FlatMaker* maker = nullptr;  // nullptr: no 2D view
    FlatImage shown;             // the newest
    FlatJob requested;           // its document follows edits that change no value
    uint64_t first = 1;          // first version of the open graph
    uint64_t images = 0;         // when it changes, image files are read again
    uint32_t texture = 0;        // texture of `shown`; 0: none
    bool gl = false;             // textures can be made
    std::string handle;          // port of the handle that is dragged; "": none
    std::string merge;           // merge key of its undo steps
    FlatPanel panel;             // of the newest frame; empty if the view was not drawn
    std::string at_pointer;      // position and value, as shown; "": none

    // Called when another graph is opened or the textures are lost.
    void forget() {
        shown = {};
        requested.node.clear();
        first = requested.version + 1;
    }
    bool idle() const { return !maker || maker->idle(); }
};

// Returns the node that the 2D view shows: the one that is selected, else the previewed one, else
// the first with values that feeds an output; "" if there is none.
std::string flat_node(const State& state);
// Returns the rectangle of a view of width x height pixels, with at most 262,144 points.
FlatArea area_of(const FlatView& view, float width, float height);
void take_flat(FlatFeed& feed);  // takes a finished job, once a frame
// Posts a job if the node, its values or the rectangle differ.
void feed_flat(State& state, const FlatArea& area);
// Returns the lanes at (u, v); std::nullopt outside of the image.
std::optional<std::vector<double>> values_at(const FlatImage& image, double u, double v);

}  // namespace wrinkle::editor

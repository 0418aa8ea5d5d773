// Connects document and node previews: requests them and stores the newest.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "editor/view/look/preview_atlas.h"
#include "editor/view/preview/node_previews.h"

namespace wrinkle::editor {

struct State;

struct NodeFeed {
    NodePreviewMaker* maker = nullptr;  // nullptr: no node previews
    PreviewAtlas atlas;
    NodePreviews previews;     // the newest; its texels are in the atlas
    NodePreviewJob requested;  // the newest job; its document follows edits that change no preview
    uint64_t first = 1;   // first version of the open graph; older previews are another graph's
    uint64_t images = 0;  // when it changes, image files are read again

    bool has_asked() const { return requested.version >= first; }
    // Called when another graph is opened or the textures are lost.
    void forget() {
        previews = {};
        first = requested.version + 1;
    }
    bool idle() const { return !maker || maker->idle(); }
};

// Returns where the atlas has the preview of the node; nullopt if it does not.
std::optional<PreviewAtlas::Place> preview_place(const NodeFeed& feed, std::string_view node);

// Takes a finished job; posts a new one if no other work is pending, so that the main preview is
// drawn first.
void feed_node_previews(State& state);

}  // namespace wrinkle::editor

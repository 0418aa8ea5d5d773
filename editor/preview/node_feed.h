// Between the document and the pictures on cards: which are wanted, of which document they are.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "editor/look/picture_atlas.h"
#include "editor/preview/node_pictures.h"

namespace wrinkle::editor {

struct State;

struct NodeFeed {
    NodePictureMaker* maker = nullptr;  // nullptr: no pictures
    PictureAtlas atlas;
    NodePictures pictures;  // the newest; its texels are in the atlas
    uint64_t asked = 0;     // the newest job's version
    uint64_t first = 1;     // of the graph that is open; older pictures are another's
    uint64_t images = 0;    // when it changes, image files are read again
    // What that job was of.
    Document asked_of;
    std::set<std::string> asked_nodes;
    const Registry* asked_registry = nullptr;
    uint64_t asked_images = 0;

    bool has_asked() const { return asked >= first; }
    // Another graph is open, or the textures are lost.
    void forget() {
        pictures = {};
        first = asked + 1;
    }
    bool idle() const { return !maker || maker->idle(); }
};

// Takes what has come; asks for more once nothing else is on its way, so that the large picture
// comes first.
void feed_node_pictures(State& state);

}  // namespace wrinkle::editor

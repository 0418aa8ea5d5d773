// What was dropped on the window and waits for somebody.
#pragma once

#include <string>
#include <vector>

#include "editor/input/input_queue.h"

namespace wrinkle::editor {

struct Dropped {
    std::vector<FileDrop> arrived;  // since the last frame
    FileDrop outside;    // some of its files lie outside the graph's folder: shall they be copied?
    bool asked = false;  // that question is open
    bool by_name = false;  // they were chosen for that place, "" for a new node
    std::string node, port;
    std::string for_preview;  // a mesh or an environment; the preview takes it and clears it
};

}  // namespace wrinkle::editor

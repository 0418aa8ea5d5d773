// What was dropped on the window and waits for somebody.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "editor/input/input_queue.h"

namespace wrinkle::editor {

// Pictures on their way into the graph: what they are is being found out.
struct Arrival {
    std::vector<std::filesystem::path> files;  // canonical; the first one is placed next
    ImVec2 at{0, 0};                           // canvas units
    bool chosen = false;                       // by name: for no place in particular
    bool layered = false;  // those before were shown: the next is laid over them
    std::string merge;
};

struct Dropped {
    std::vector<FileDrop> arrived;  // since the last frame
    FileDrop outside;    // some of its files lie outside the graph's folder: shall they be copied?
    bool asked = false;  // that question is open
    bool by_name = false;  // they were chosen for that place, "" for a new node
    std::string node, port;
    std::vector<Arrival> waiting;  // the first one is placed first
    std::string for_preview;       // a mesh or an environment; the preview takes it and clears it

    bool waits_for(const std::filesystem::path& file) const {
        return std::any_of(waiting.begin(), waiting.end(), [&](const Arrival& each) {
            return std::find(each.files.begin(), each.files.end(), file) != each.files.end();
        });
    }
};

}  // namespace wrinkle::editor

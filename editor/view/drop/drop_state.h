// Dropped files that wait for processing.
#pragma once

#include <imgui.h>

#include <filesystem>
#include <string>
#include <vector>

#include "editor/view/input/input_queue.h"

namespace wrinkle::editor {

// Images being added to the graph, while they are examined.
struct DropEvent {
    std::vector<std::filesystem::path> files;  // canonical; the first one is added next
    ImVec2 at{0, 0};                           // canvas units
    bool chosen = false;                       // chosen by name: without a position
    bool layered = false;  // earlier images are shown: the next is layered over them
    std::string merge;
};

struct DropState {
    bool has_question() const { return !outside.files.empty() || !graph.files.empty(); }

    std::vector<FileDrop> arrived;  // since the last frame
    FileDrop outside;      // not empty: some files are outside the graph's folder. Copy them?
    FileDrop graph;        // not empty: a graph to open or to use as a node
    bool by_name = false;  // chosen by name for `node` and `port`, "" for a new node
    std::string node, port;
    std::vector<DropEvent> waiting;  // the first one is added first
};

}  // namespace wrinkle::editor

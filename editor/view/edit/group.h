// Groups and ungroups selected nodes, and opens a sub-graph.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

// Returns the selected node if it is the only one and a sub-graph; otherwise nullptr.
const Node* selected_group(const State& state);
// Opens its graph (document/levels.h).
void open_selected_group(State& state);

// Groups the selected nodes in one undo step; writes the new graph next to the document's file.
void group_selected(State& state);

// Inlines the one selected sub-graph in one undo step; its file remains.
void ungroup_selected(State& state);

}  // namespace wrinkle::editor

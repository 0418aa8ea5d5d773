// The search box that adds a node or runs a command: type, choose with the arrows, Enter places.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

void draw_palette(State& state);

// The node types that a query finds, best first: the beginning of a name before its inside before
// letters in order; only those that fit the palette's wire.
std::vector<const NodeType*> search_nodes(const State& state, std::string_view query);

}  // namespace wrinkle::editor

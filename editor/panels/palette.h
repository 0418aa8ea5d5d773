// The search box that adds a node or runs a command: type, choose with the arrows or the mouse,
// Enter places. At the end of a wire it lists what has a port for it; Tab lists everything.
#pragma once

#include "editor/panels/search.h"
#include "editor/state.h"

namespace wrinkle::editor {

void draw_palette(State& state);

// What a query finds, best first: by the rank of search.h, then without a conversion before with
// one, then the lately used, then the shorter title. An empty query lists the lately used first,
// then pictures, bumps, noises and the rest.
struct FoundNode {
    const NodeType* type = nullptr;
    Match match;
};
std::vector<FoundNode> find_nodes(const State& state, std::string_view query);
std::vector<const NodeType*> search_nodes(const State& state, std::string_view query);

// One line of the list.
struct PaletteRow {
    std::string title, doc, key;
    std::string off;     // why it cannot be chosen; "" when it can
    std::string target;  // its name for scripts
    std::vector<size_t> letters;
    const NodeType* type = nullptr;
    const struct Command* command = nullptr;
    std::string node;  // of the graph, to be shown
};
std::vector<PaletteRow> palette_rows(const State& state);

// Remembers what was chosen.
void note_use(std::vector<std::string>& recent, std::string_view id);

}  // namespace wrinkle::editor

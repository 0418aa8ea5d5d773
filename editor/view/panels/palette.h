// Search box that adds or shows a node, runs a command or returns to an undo step: type, choose
// with the arrow keys or the mouse, Enter accepts. For a wire it lists types with a matching port,
// and all graphs of the folder and of the library: their ports are read when one is chosen. Tab
// lists all types.
#pragma once

#include "editor/view/panels/search.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

// One row of the list.
struct PaletteRow {
    std::string title, doc, key = {};
    std::string off = {};  // why it cannot be chosen; "" if it can
    std::string target;    // its name for scripts
    std::vector<size_t> letters = {};
    const NodeType* type = nullptr;
    const struct Command* command = nullptr;
    std::string node = {};                // id of a node of the graph to show
    std::string graph = {};               // file of a sub-graph to add
    const LibraryEntry* entry = nullptr;  // graph of the library to add
    std::optional<size_t> step{};         // index in the history
    bool favorite = false;

    bool is_node() const { return type || entry || !graph.empty(); }
    // The type of the node that the row adds, as nodes name it; "" if it adds none.
    std::string added_type() const;
};
// Returns the rows that match the query, best first. Sort keys of node types: the rank of search.h,
// no conversion on the wire before a conversion, favorites first, most recently used first, shorter
// title first. For an empty query, the last key is the family instead: images, gradients, noises,
// the rest, graphs of the folder, those of the library.
std::vector<PaletteRow> palette_rows(const State& state);

// Adds the type that the row adds to the favorites of the settings, or removes it.
void toggle_favorite(State& state, const PaletteRow& row);

// Moves the id to the front of the recently used ids; stores at most 8.
void note_use(std::vector<std::string>& recent, std::string_view id);

}  // namespace wrinkle::editor

// Tidy: places cards in columns, each right of all its sources, avoids wires behind cards if
// possible, and fits frames around the nodes that were in them. Lengths in canvas units, positions
// on the grid.
//
// A column holds nodes of equal depth; a node with no more wires from nodes than wires to readers
// is next to its readers. Sweeps over the columns move each card to the height of its wires, in the
// gaps between wires of other cards. The result is the sweep with the fewest hidden wires, then
// with the smallest sum of height differences of wires. Cards do not overlap. O(sweeps * cards *
// wires that cross a column) at most.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

struct Tidied {
    Document document;
    View::Borders borders;
};
Tidied tidied(const State& state);
// Arranges only the selected nodes, with the same upper left corner.
Document tidied_selection(const State& state);

// Number of wires that run behind a card that is not at one of their ends.
size_t hidden_wires(const Layout& layout);

}  // namespace wrinkle::editor

// Tidy: cards in columns, each right of all that it is made of, so placed that no wire runs behind
// a card where that can be had, and frames around the nodes that were in them. Lengths in canvas
// units, places on the grid.
//
// A column holds what is equally deep in wires; what only the surface feeds is beside its readers.
// Sweeps over the columns bring each card to the height of its wires, in the gaps that wires
// between other cards leave; of all sweeps the one counts that hides the fewest wires, then the one
// with the shortest. O(sweeps * cards * wires that cross a column) at most; no card covers another.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

struct Tidied {
    Document document;
    View::Borders borders;
};
Tidied tidied(const State& state);
// The selected nodes among themselves, where they are.
Document tidied_selection(const State& state);

// How many wires run behind a card that is not at one of their ends.
size_t hidden_wires(const Layout& layout);

}  // namespace wrinkle::editor

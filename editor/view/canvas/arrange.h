// Arranges cards: aligns, distributes, snaps and tidies them, and makes space between them. The
// functions that return a document change only positions in it.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

enum class Side : uint8_t { left, right, top, bottom, middle_x, middle_y };

Document aligned(const State& state, Side side);
// Equal gaps between the two outermost cards; returns the document unchanged for fewer than three.
Document distributed(const State& state, bool across);
Document snapped(const State& state);  // to the grid of 8

// Tidy: places cards in columns, each right of all its sources, avoids wires behind cards if
// possible, and fits frames around the nodes that were in them. Lengths in canvas units, positions
// on the grid.
//
// A column holds nodes of equal depth; but a node with at least as many outgoing wires as incoming
// wires from nodes is in the column left of its nearest user. Sweeps over the columns move each
// card to the height of its wires, in the gaps between wires of other cards. The result is the
// sweep with the fewest hidden wires, then with the smallest sum of height differences of wires.
// Cards do not overlap. O(sweeps * cards * wires that cross a column) at most.
struct Tidied {
    Document document;
    Borders borders;
};
Tidied tidied(const State& state);
// Arranges only the selected nodes, with the same upper left corner.
Document tidied_selection(const State& state);

// Returns the document with the cards that `card` overlaps moved aside: those on its right move
// right with everything downstream, the others move left with everything upstream. If the outputs
// card has to move too, `outputs_at` receives its new position.
Document make_space(const State& state, const Document& document, const Card& card,
                    std::optional<ImVec2>& outputs_at);

// Moves the surface and outputs cards as part of the last committed step; undo moves them back.
void push_borders(State& state, const Borders& to);
// Applies the undo or redo of the step that leads to state `serial` to these cards.
void follow_step(CanvasState& canvas, uint64_t serial, bool undone);

}  // namespace wrinkle::editor

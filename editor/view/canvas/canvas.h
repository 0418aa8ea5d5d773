// The canvas: draws cards and wires at screen scale, hit-tests the pointer, and turns gestures into
// edits. One InvisibleButton takes all input; there are no ImGui widgets on nodes.
#pragma once

#include <optional>
#include "editor/view/look/draw.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

// The panel: fills the current ImGui window.
//
//   drag on empty ground     box select; Ctrl + Shift: lasso
//   middle drag, Alt + drag  pan
//   wheel                    zoom at the pointer
//   drag a header or body    move the selection
//   drag a field             change a number (Ctrl fine, Shift coarse; both: scale the vector)
//   drag pin to pin          connect; from a connected input: detach the wire; to empty ground:
//                            open the palette, filtered by fitting types
//   double-click a field     type a value
//   double-click a header    rename; on the card of a sub-graph, off its name: open it
//   double-click a wire      insert a reroute
//   drop a loose node on a wire   insert it into the wire
//   Alt + right drag         from node to node: connect the best-fitting pins
//   Ctrl + right drag        cut the crossed wires
//   Shift + right drag       insert a reroute into each crossed wire
//   Escape                   cancel the gesture
void draw_canvas(State& state);

// Moves all nodes, or the selected ones, into sight (fit(), layout.h); another panel that fills the
// window gives way to the canvas.
void show_nodes(State& state, bool selection_only);

// Parts of draw_canvas().
Hit pick(const State& state, ImVec2 mouse);
void draw_graph(const State& state, ImDrawList& list);
void draw_gesture(const State& state, ImDrawList& list);  // feedback of the gesture in progress
void update_gesture(State& state, bool active);
void name_targets(State& state);  // for scripts and tests (input/targets.h)
// The rectangle of the hit row of a card, which a tooltip must not cover.
About about_hit(const CanvasState& canvas, const Hit& hit);

// Connects the loose end of a wire; on failure sets state.status to the reason.
void connect_wire(State& state, const Gesture& wire, const Card& card, const Pin& pin);
bool wire_fits(const State& state, const Gesture& wire, const Card& card, const Pin& pin);

// Geometry of wires, in canvas units.
Curve curve_of(const Wire& wire);
Curve curve_on_screen(const View& view, const Wire& wire);  // in screen pixels

// Returns the first intersection of the wire with the segment from a to b; std::nullopt if none.
std::optional<ImVec2> crossing(const Layout& layout, size_t wire, ImVec2 a, ImVec2 b);

// Returns the wire under the card that is nearest to its center, except wires of the card itself.
std::optional<size_t> wire_under(const Layout& layout, const Card& card);

}  // namespace wrinkle::editor

// The canvas: draws cards and wires at screen scale, finds what is under the pointer, and turns
// gestures into edits. One InvisibleButton takes all input; there are no widgets on nodes.
//
//   drag on empty ground     box select
//   middle drag, Alt + drag  pan
//   wheel                    zoom at the pointer
//   drag a header or body    move the selection
//   drag a field             change a number (Ctrl fine, Shift coarse)
//   drag pin to pin          connect; from a connected input: take the wire off; to empty ground:
//                            the palette, filtered by what fits
//   double-click a field     type a value
//   double-click a header    rename
//   double-click a wire      a reroute
//   drop a loose node on a wire   it stands in the wire
//   Alt + right drag         from node to node: connects what fits best
//   Ctrl + right drag        cuts the wires that it crosses
//   Shift + right drag       a reroute in each wire that it crosses
//   Escape                   takes the gesture back
#pragma once

#include "editor/look/tooltip.h"
#include "editor/state.h"

namespace wrinkle::editor {

void draw_canvas(State& state);  // the panel: into the current ImGui window, all of its space

// Its parts.
Hit pick(const State& state, ImVec2 mouse);
void draw_graph(const State& state, ImDrawList& list);
void draw_gesture(const State& state, ImDrawList& list);  // what the hand is doing
void update_gesture(State& state, bool active);
void name_targets(State& state);
// What a tooltip about a card's part must not cover: its row.
About about_hit(const State& state, const Hit& hit);

// Connects the loose end of a wire; says why when it cannot.
void connect_wire(State& state, const Gesture& wire, const Card& card, const Pin& pin);
bool wire_fits(const State& state, const Gesture& wire, const Card& card, const Pin& pin);

}  // namespace wrinkle::editor

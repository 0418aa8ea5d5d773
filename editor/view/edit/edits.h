// Edits of the canvas and the panels: they act on the selection and find positions for new nodes.
#pragma once

#include <optional>
#include <string>

#include "editor/view/state.h"

namespace wrinkle::editor {

// Adds a node of a type near `at` (canvas units), with an id derived from the type, and connects it
// to the loose end of `wire` by the first port that fits.
void add_node_of_type(State& state, const NodeType& type, ImVec2 at, const Gesture& wire);
// Inserts the node into the selected wire if it fits; else adds it to the right of the selected
// nodes and connects their outputs to it.
void add_node_to_selection(State& state, const NodeType& type, ImVec2 at);
// Returns true if a node of that type has a port that fits `wire`.
bool type_fits(const NodeType& type, const Gesture& wire);
bool type_matches(const NodeType& type, const Gesture& wire);  // without a conversion

void delete_selected(State& state);  // reconnects sources and users if the types convert
void delete_selected_with_wires(State& state);
// Copies each selected node; wires among them connect the copies. Wires from other nodes are
// retained if `with_inputs`.
void duplicate_selected(State& state, bool with_inputs = true);
void swap_selected(State& state);
void frame_selected(State& state);  // a frame around them, or an empty one at the pointer
void add_note(State& state);        // at the pointer
void edit_box_text(State& state, const BoxId& id);
void accept_box_text(State& state);
void mute_selected(State& state);

// Computes once, for all pins and frames, the nodes to which this wire would make a cycle.
void find_loops(const Document& document, Gesture& wire);
// Returns the reason why a wire may not end at this pin; "" if it may.
std::string why_not(const State& state, const Gesture& wire, const Card& card, const Pin& pin);

// Initial text of the text field over a number, with all digits.
std::string typed_value(const Node& node, const Port& port, int lane);

void open_palette(State& state, ImVec2 at, const Gesture& wire);

}  // namespace wrinkle::editor

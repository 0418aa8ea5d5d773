// Edits as the panels make them, over graph/edit.h: an output of the graph counts as an input of
// the node "".
#pragma once

#include <optional>
#include <string>

#include "editor/state.h"

namespace wrinkle::editor {

std::optional<Link> link_at(const Document& document, const std::string& node,
                            const std::string& port);
Document with_wire(const Document& document, const Link& from, const std::string& node,
                   const std::string& port);
Document without_wire(const Document& document, const std::string& node, const std::string& port);

// A new node of a type, with an id after the type, at a place near `at` (canvas units); connected
// to the loose end of `wire` by the first port that fits.
void add_node_of_type(State& state, const NodeType& type, ImVec2 at, const Gesture& wire);
// The same in the selected wire, where it fits; else fed by the selected nodes, to their right.
void add_node_to_selection(State& state, const NodeType& type, ImVec2 at);
// Whether a node of that type has a port for it.
bool type_fits(const NodeType& type, const Gesture& wire);
bool type_matches(const NodeType& type, const Gesture& wire);  // without a conversion

void delete_selected(State& state);  // what fed the nodes feeds their readers, where it fits
void delete_selected_with_wires(State& state);
// A copy of each selected node; wires among them run among the copies. With the wires from others.
void duplicate_selected(State& state, bool with_inputs = true);
void swap_selected(State& state);
void frame_selected(State& state);  // a frame around them, or an empty one at the pointer
void add_note(State& state);        // at the pointer
void edit_box_text(State& state, const BoxId& id);
void accept_box_text(State& state);
void mute_selected(State& state);

// Finds once, for all pins and frames, the nodes that this wire cannot go to.
void find_loops(const Document& document, Gesture& wire);
// Why a wire may not end at this pin; "" when it may.
std::string why_not(const State& state, const Gesture& wire, const Card& card, const Pin& pin);

// What the text field over a number begins with, all digits.
std::string typed_value(const Node& node, const Port& port, int lane);

void open_palette(State& state, ImVec2 at, const Gesture& wire);

}  // namespace wrinkle::editor

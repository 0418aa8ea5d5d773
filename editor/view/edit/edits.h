// Edits of the canvas and the panels: they act on the selection and find positions for new nodes.
#pragma once

#include <string>

#include "editor/model/document/wiring.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

// Returns a node of the type with a new id derived from it, for a sub-graph from its file's name.
Node node_of_type(const Document& document, const NodeType& type);
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

// Undo and redo, with the positions of the surface and outputs cards.
void undo_step(State& state);
void redo_step(State& state);
void go_to_step(State& state, size_t step);  // an index of History

struct PortOfNode {
    std::string node;
    const Port* port = nullptr;
};
// The value or input under the pointer; without a port if there is none.
PortOfNode pointed_port(const State& state);

// The other selected nodes of the node's type that have no wire at the port; none if the port has
// one.
std::vector<std::string> copy_targets(const State& state, const PortOfNode& value);
void copy_value(State& state, const PortOfNode& value);  // to these, as one undo step
void copy_pointed_value(State& state);
std::string_view no_copied_value(const State& state);  // why not, a sentence; "" if it can

// Makes an input of the graph of the value or input under the pointer; otherwise of values of the
// selected nodes, chosen in a list if they have several (document/expose.h).
void expose_pointed(State& state);
std::string_view no_exposable(const State& state);  // why not, a sentence; "" if it can
std::vector<PortOfNode> exposable_of_selected(const State& state);
void expose_ports(State& state, const std::vector<PortOfNode>& ports);  // one undo step

// Computes once, for all pins and frames, the nodes to which this wire would make a cycle.
void find_loops(const Document& document, Gesture& wire);
// Returns the connection that the wire makes at this pin.
Connection connection_at(const Gesture& wire, const Card& card, const Pin& pin);
void commit_connection(State& state, const Connection& to, const std::string& merge = {});
// Returns the reason why a wire may not end at this pin; "" if it may.
std::string why_not(const State& state, const Gesture& wire, const Card& card, const Pin& pin);

void open_palette(State& state, ImVec2 at, const Gesture& wire);
// Opens the palette with that list in the upper middle of the canvas.
void open_list(State& state, Palette::List list);

// Returns the selected node if exactly one is selected; otherwise nullptr.
const Node* selected_node(const State& state);
// Returns selected_node() if it is a sub-graph; otherwise nullptr.
const Node* selected_group(const State& state);
// Opens its graph (document/levels.h).
void open_selected_group(State& state);

// Groups the selected nodes in one undo step; writes the new graph next to the document's file.
void group_selected(State& state);

// Inlines the one selected sub-graph in one undo step; its file remains.
void ungroup_selected(State& state);

// Returns node types that convert a wire: they take the type `from` and return one that all of
// `ends` take. At most `most`, the best first; empty if no single node converts.
std::vector<Offer::Choice> between(const Registry& registry, PortType from,
                                   const std::vector<PortType>& ends, size_t most = 3);

// Opens the offer at the pointer for a wire that was dropped at a pin of another type.
void offer_between(State& state, const Gesture& wire, const Card& card, const Pin& pin);
// Inserts the chosen node between the two ends in one undo step.
void accept_offer(State& state, size_t choice);

}  // namespace wrinkle::editor

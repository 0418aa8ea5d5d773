// Edits: Document -> Document. Pure; whatever is not changed is shared with the original, and an
// edit that would change nothing, names something that does not exist, or gives an impossible name
// returns the original itself (`edited` unchanged, all tables `same`).
#pragma once

#include <string>
#include <string_view>

#include "graph/document.h"

namespace wrinkle {

// `id` must be free and valid; a new node is appended, with its position when one is given.
Document add_node(const Document&, Node node);
Document add_node(const Document&, Node node, double x, double y);
// With its wires in and out, its outputs and its position.
Document remove_node(const Document&, std::string_view id);
// All links, outputs and the layout follow.
Document rename_node(const Document&, std::string_view id, std::string_view new_id);
// A port of a node, input or output: its value and every link to it follow. For upgrades.
Document rename_port(const Document&, std::string_view id, std::string_view port,
                     std::string_view new_port);
// `base`, or `base2`, `base3`, ... whichever is free.
std::string free_id(const Document&, std::string_view base);

// The ends need not exist, and a cycle is not refused: `check_links` reports them.
Document connect(const Document&, const Link& from, std::string_view id, std::string_view port);
Document disconnect(const Document&, std::string_view id, std::string_view port);  // only a link
Document set_value(const Document&, std::string_view id, std::string_view port, json::Value value);
Document reset_value(const Document&, std::string_view id, std::string_view port);  // value or link
Document set_muted(const Document&, std::string_view id, bool muted);
Document set_type(const Document&, std::string_view id, std::string_view type, int version);

Document set_output(const Document&, std::string_view name, const Link& from);
Document remove_output(const Document&, std::string_view name);
Document set_graph_input(const Document&, GraphInput input);  // added or replaced by its name
Document remove_graph_input(const Document&, std::string_view name);  // its readers stay
Document set_name(const Document&, std::string_view name);
Document set_back_faces(const Document&, BackFaces choice);

// Layout alone.
Document move_node(const Document&, std::string_view id, double x, double y);
Document set_frame(const Document&, Box frame);  // added or replaced by its id
Document remove_frame(const Document&, std::string_view id);
Document set_note(const Document&, Box note);
Document remove_note(const Document&, std::string_view id);

// Whether a wire from `from` to node `id` would close a cycle.
bool would_cycle(const Document&, const Link& from, std::string_view id);

}  // namespace wrinkle

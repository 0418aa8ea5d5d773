// Edits: Document -> Document. Pure functions; the result shares unchanged parts with the original.
// An edit that has no effect, refers to a missing item, or gives an invalid name returns the
// original (`edited` unchanged, all tables `same`).
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "graph/document.h"

namespace wrinkle {

// `id` must be free and valid; a new node is appended, with its position if one is given.
Document add_node(const Document&, Node node);
Document add_node(const Document&, Node node, double x, double y);
// Also removes its links in and out, its outputs and its position.
Document remove_node(const Document&, std::string_view id);
// Also updates all links, outputs and the layout.
Document rename_node(const Document&, std::string_view id, std::string_view new_id);
// Returns `base`, or the first of `base2`, `base3`, ... that is neither in the document nor in
// `taken`.
std::string free_id(const Document&, std::string_view base,
                    const std::set<std::string>& taken = {});

// Edits of several nodes, in one pass over the document.
struct NodePosition {
    std::string id;
    double x = 0, y = 0;
};
Document add_nodes(const Document&, std::vector<Node> nodes,
                   const std::vector<NodePosition>& places);
Document remove_nodes(const Document&, const std::set<std::string>& ids);
Document move_nodes(const Document&, const std::vector<NodePosition>& places);
Document mute_nodes(const Document&, const std::set<std::string>& ids, bool muted);

// Upgrade of a node to a version of its type. Values of renamed inputs and links to renamed outputs
// are carried over; the renames are applied in order.
struct NodeUpgrade {
    struct Rename {
        std::string old_name, new_name;
    };
    std::string id;
    int version = 1;
    std::vector<Rename> inputs, outputs;
};
Document upgrade_nodes(const Document&, const std::vector<NodeUpgrade>& upgrades);

// The ends need not exist, and a cycle is not rejected: `check_links` reports both.
Document connect(const Document&, const Link& from, std::string_view id, std::string_view port);
Document disconnect(const Document&, std::string_view id, std::string_view port);  // links only
Document set_value(const Document&, std::string_view id, std::string_view port, json::Value value);
Document reset_value(const Document&, std::string_view id, std::string_view port);  // value or link
Document set_type(const Document&, std::string_view id, std::string_view type, int version);

Document set_output(const Document&, std::string_view name, const Link& from);
Document remove_output(const Document&, std::string_view name);
Document set_graph_input(const Document&, GraphInput input);  // adds or replaces by name
// Also updates its wires, its values in presets, and conditions that name it; its position in the
// table is unchanged. `is_known`: other files may use the old name, so it becomes a former name
// (graph/renamed.h). A name that is a former name of another input is invalid.
Document rename_graph_input(const Document&, std::string_view name, std::string_view new_name,
                            bool is_known);
// Also removes its wires, outputs that read it, its values in presets, and conditions that name it.
Document remove_graph_input(const Document&, std::string_view name);
Document set_preset(const Document&, Preset preset);  // adds or replaces by name
Document remove_preset(const Document&, std::string_view name);
Document set_back_faces(const Document&, std::optional<BackFaces> choice);

// Layout only.
Document move_node(const Document&, std::string_view id, double x, double y);
// `boxes` is &Document::frames or &Document::notes.
Document set_box(const Document&, Table<Box> Document::*boxes, Box box);  // adds or replaces by id
Document remove_box(const Document&, Table<Box> Document::*boxes, std::string_view id);

// Returns true if a wire from `from` to node `id` would close a cycle.
bool would_cycle(const Document&, const Link& from, std::string_view id);

enum class Direction : uint8_t { upstream, downstream };
// Returns the ids and all nodes that they depend on (upstream), or that depend on them.
std::set<std::string> reachable(const Document&, std::set<std::string> ids, Direction direction);

}  // namespace wrinkle

// Edits: Document -> Document. Pure; whatever is not changed is shared with the original, and an
// edit that would change nothing, names something that does not exist, or gives an impossible name
// returns the original itself (`edited` unchanged, all tables `same`).
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "graph/document.h"

namespace wrinkle {

// `id` must be free and valid; a new node is appended, with its position when one is given.
Document add_node(const Document&, Node node);
Document add_node(const Document&, Node node, double x, double y);
// With its wires in and out, its outputs and its position.
Document remove_node(const Document&, std::string_view id);
// All links, outputs and the layout follow.
Document rename_node(const Document&, std::string_view id, std::string_view new_id);
// `base`, or `base2`, `base3`, ... whichever is neither in the document nor taken.
std::string free_id(const Document&, std::string_view base,
                    const std::set<std::string>& taken = {});

// Several nodes at once, in one pass over the document.
struct NodePosition {
    std::string id;
    double x = 0, y = 0;
};
Document add_nodes(const Document&, std::vector<Node> nodes,
                   const std::vector<NodePosition>& places);
Document remove_nodes(const Document&, const std::set<std::string>& ids);
Document move_nodes(const Document&, const std::vector<NodePosition>& places);
Document mute_nodes(const Document&, const std::set<std::string>& ids, bool muted);

// A node brought to a version of its type. Renamed inputs take their values along, every link to a
// renamed output follows; the renames are applied in their order.
struct NodeUpgrade {
    struct Rename {
        std::string old_name, new_name;
    };
    std::string id;
    int version = 1;
    std::vector<Rename> inputs, outputs;
};
Document upgrade_nodes(const Document&, const std::vector<NodeUpgrade>& upgrades);

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
// All nodes whose wire with `id` would close one, itself among them: of a wire that begins at `id`
// those that it depends on, of one that ends there those that depend on it.
std::set<std::string> cycle_partners(const Document&, std::string_view id, bool begins);

}  // namespace wrinkle

#include <algorithm>
#include <unordered_map>

#include "graph/edit.h"
#include "graph/edit_parts.h"

namespace wrinkle {
namespace {

using editing::copy_of;
using editing::mark_edited;

// Applies `change` to a copy of every node that it concerns; returns true if there was any.
template <class Change>
bool change_nodes(Document& document, Change change) {
    std::vector<NodePtr> nodes(document.nodes.begin(), document.nodes.end());
    bool changed = false;
    for (NodePtr& node : nodes) {
        if (!change.concerns(*node)) continue;
        Node copy = copy_of(*node);
        change.apply(copy);
        mark_edited(copy);
        node = std::make_shared<const Node>(std::move(copy));
        changed = true;
    }
    if (changed) document.nodes = Table<NodePtr>(std::move(nodes));
    return changed;
}

template <class Change>
bool any_concerned(const Node& node, const Change& change) {
    return std::any_of(node.inputs.begin(), node.inputs.end(),
                       [&](const Input& input) { return change.concerns(input); });
}

template <class Change>
void apply_to_inputs(Node& node, const Change& change) {
    for (Input& input : node.inputs)
        change.apply(input);
}

// Applies `change` to the link of every output that it concerns; returns true if there was any.
template <class Change>
bool change_outputs(Document& document, const Change& change) {
    const auto concerned = [&](const Output& output) { return change.concerns(output.from); };
    if (std::none_of(document.outputs.begin(), document.outputs.end(), concerned)) return false;
    std::vector<Output> outputs(document.outputs.begin(), document.outputs.end());
    for (Output& output : outputs)
        change.apply(output.from);
    document.outputs = Table<Output>(std::move(outputs));
    return true;
}

// Removes the entries for which `dropped` is true; returns true if there was any.
template <class T, class Dropped>
bool erase_if(Table<T>& table, Dropped dropped) {
    std::vector<T> kept(table.begin(), table.end());
    if (std::erase_if(kept, dropped) == 0) return false;
    table = Table<T>(std::move(kept));
    return true;
}

struct DropLinks {
    const std::set<std::string>& ids;

    bool concerns(const Input& input) const { return ids.contains(input.link.node); }
    bool concerns(const Node& node) const { return any_concerned(node, *this); }
    void apply(Node& node) const {
        std::erase_if(node.inputs, [&](const Input& input) { return concerns(input); });
    }
};

struct RenameLinks {
    std::string_view id, new_id;

    bool concerns(const Input& input) const { return input.link.node == id; }
    bool concerns(const Node& node) const { return any_concerned(node, *this); }
    void apply(Input& input) const {
        if (concerns(input)) editing::set_link(input, {std::string(new_id), input.link.port});
    }
    void apply(Node& node) const { apply_to_inputs(node, *this); }
};

struct Mute {
    const std::set<std::string>& ids;
    bool muted;

    bool concerns(const Node& node) const { return node.muted != muted && ids.contains(node.id); }
    void apply(Node& node) const { node.muted = muted; }
};

class Upgrades {
public:
    explicit Upgrades(const std::vector<NodeUpgrade>& upgrades) {
        for (const NodeUpgrade& upgrade : upgrades)
            by_id_.emplace(upgrade.id, &upgrade);
    }

    bool concerns(const Input& input) const {
        return input.link.is_node() && renamed(input.link) != input.link.port;
    }
    bool concerns(const Node& node) const {
        if (const NodeUpgrade* upgrade = find(node.id)) {
            if (upgrade->version != node.version) return true;
            for (const NodeUpgrade::Rename& rename : upgrade->inputs)
                if (node.find(rename.old_name) && !node.find(rename.new_name)) return true;
        }
        return any_concerned(node, *this);
    }

    void apply(Input& input) const {
        if (concerns(input)) editing::set_link(input, {input.link.node, renamed(input.link)});
    }
    void apply(Node& node) const {
        apply_to_inputs(node, *this);
        const NodeUpgrade* upgrade = find(node.id);
        if (!upgrade) return;
        node.version = upgrade->version;
        for (const NodeUpgrade::Rename& rename : upgrade->inputs)
            for (Input& input : node.inputs)
                if (input.port == rename.old_name && !node.find(rename.new_name))
                    input.port = rename.new_name;
    }

private:
    const NodeUpgrade* find(const std::string& id) const {
        const auto found = by_id_.find(id);
        return found == by_id_.end() ? nullptr : found->second;
    }
    std::string renamed(const Link& link) const {
        std::string port = link.port;
        if (const NodeUpgrade* upgrade = find(link.node))
            for (const NodeUpgrade::Rename& rename : upgrade->outputs)
                if (rename.old_name == port) port = rename.new_name;
        return port;
    }

    std::unordered_map<std::string, const NodeUpgrade*> by_id_;
};

// Marks the nodes reachable from `start` by index, including `start`.
std::vector<bool> reached(const std::vector<std::vector<size_t>>& edges, size_t start) {
    std::vector<bool> seen(edges.size(), false);
    std::vector<size_t> todo{start};
    while (!todo.empty()) {
        const size_t i = todo.back();
        todo.pop_back();
        if (i >= seen.size() || seen[i]) continue;
        seen[i] = true;
        todo.insert(todo.end(), edges[i].begin(), edges[i].end());
    }
    return seen;
}

// Returns for each node those that it reads; if `reversed`, those that read it.
std::vector<std::vector<size_t>> edges_of(const Document& document, bool reversed) {
    std::vector<std::vector<size_t>> edges(document.nodes.size());
    for (size_t i = 0; i < edges.size(); ++i)
        for (const Input& input : document.nodes[i]->inputs) {
            if (!input.link.is_node()) continue;
            const size_t from = document.nodes.index_of(input.link.node);
            if (from != Table<NodePtr>::npos)
                edges[reversed ? from : i].push_back(reversed ? i : from);
        }
    return edges;
}

}  // namespace

Document add_node(const Document& document, Node node) {
    return add_nodes(document, {std::move(node)}, {});
}

Document add_node(const Document& document, Node node, double x, double y) {
    const std::string id = node.id;
    return add_nodes(document, {std::move(node)}, {{id, x, y}});
}

Document remove_node(const Document& document, std::string_view id) {
    return remove_nodes(document, {std::string(id)});
}

Document rename_node(const Document& document, std::string_view id, std::string_view new_id) {
    const Node* node = document.find(id);
    if (!node || !id_problem(new_id).empty() || document.find(new_id)) return document;
    Document changed = document;
    std::vector<NodePtr> nodes(document.nodes.begin(), document.nodes.end());
    Node renamed = *node;
    renamed.id = new_id;
    nodes[document.nodes.index_of(id)] = std::make_shared<const Node>(std::move(renamed));
    changed.nodes = Table<NodePtr>(std::move(nodes));
    change_nodes(changed, RenameLinks{id, new_id});
    change_outputs(changed, RenameLinks{id, new_id});
    std::vector<Position> positions(document.positions.begin(), document.positions.end());
    for (Position& position : positions)
        if (position.id == id) position.id = new_id;
    changed.positions = Table<Position>(std::move(positions));
    mark_edited(changed);
    return changed;
}

std::string free_id(const Document& document, std::string_view base,
                    const std::set<std::string>& taken) {
    std::string id(base);
    if (!id_problem(id).empty()) id = "node";
    const std::string stem = id;
    for (size_t n = 2; document.find(id) || taken.contains(id); ++n)
        id = stem + std::to_string(n);
    return id;
}

Document add_nodes(const Document& document, std::vector<Node> added,
                   const std::vector<NodePosition>& places) {
    std::vector<NodePtr> nodes(document.nodes.begin(), document.nodes.end());
    std::set<std::string> ids;
    for (Node& node : added) {
        if (!id_problem(node.id).empty() || document.find(node.id)) continue;
        if (!ids.insert(node.id).second) continue;
        mark_edited(node);
        nodes.push_back(std::make_shared<const Node>(std::move(node)));
    }
    if (ids.empty()) return document;
    Document changed = document;
    changed.nodes = Table<NodePtr>(std::move(nodes));
    mark_edited(changed);
    return move_nodes(changed, places);
}

Document remove_nodes(const Document& document, const std::set<std::string>& wanted) {
    std::set<std::string> ids;  // node ids only: links to the surface remain
    for (const std::string& id : wanted)
        if (document.find(id)) ids.insert(id);
    Document changed = document;
    if (!erase_if(changed.nodes, [&](const NodePtr& node) { return ids.contains(node->id); }))
        return document;
    erase_if(changed.outputs,
             [&](const Output& output) { return ids.contains(output.from.link.node); });
    erase_if(changed.positions,
             [&](const Position& position) { return ids.contains(position.id); });
    change_nodes(changed, DropLinks{ids});
    mark_edited(changed);
    return changed;
}

Document move_node(const Document& document, std::string_view id, double x, double y) {
    return move_nodes(document, {{std::string(id), x, y}});
}

Document move_nodes(const Document& document, const std::vector<NodePosition>& places) {
    std::vector<Position> positions(document.positions.begin(), document.positions.end());
    std::unordered_map<std::string, size_t> index;
    for (size_t i = 0; i < positions.size(); ++i)
        index.emplace(positions[i].id, i);
    bool moved = false;
    for (const auto& [id, x, y] : places) {
        if (!document.find(id)) continue;
        const auto [entry, is_new] = index.emplace(id, positions.size());
        if (is_new) positions.push_back({id, x, y, {}});
        Position& position = positions[entry->second];
        if (!is_new && position.x == x && position.y == y) continue;
        position.x = x;
        position.y = y;
        moved = true;
    }
    if (!moved) return document;
    Document changed = document;
    changed.positions = Table<Position>(std::move(positions));
    mark_edited(changed);
    return changed;
}

Document set_muted(const Document& document, std::string_view id, bool muted) {
    return mute_nodes(document, {std::string(id)}, muted);
}

Document mute_nodes(const Document& document, const std::set<std::string>& ids, bool muted) {
    Document changed = document;
    if (!change_nodes(changed, Mute{ids, muted})) return document;
    mark_edited(changed);
    return changed;
}

Document upgrade_nodes(const Document& document, const std::vector<NodeUpgrade>& list) {
    const Upgrades upgrades(list);
    Document changed = document;
    const bool nodes = change_nodes(changed, upgrades);
    const bool outputs = change_outputs(changed, upgrades);
    if (!nodes && !outputs) return document;
    mark_edited(changed);
    return changed;
}

bool would_cycle(const Document& document, const Link& from, std::string_view id) {
    const size_t reader = document.nodes.index_of(id);
    if (!from.is_node() || reader == Table<NodePtr>::npos) return false;
    return reached(edges_of(document, false), document.nodes.index_of(from.node))[reader];
}

std::set<std::string> cycle_partners(const Document& document, std::string_view id, bool begins) {
    const auto found = reached(edges_of(document, !begins), document.nodes.index_of(id));
    std::set<std::string> ids;
    for (size_t i = 0; i < found.size(); ++i)
        if (found[i]) ids.insert(document.nodes[i]->id);
    return ids;
}

}  // namespace wrinkle

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "graph/depth_first.h"
#include "graph/edit.h"
#include "graph/edit_parts.h"
#include "graph/order.h"

namespace wrinkle {
namespace {

using editing::copy_of;
using editing::mark_edited;

// Applies `change` to a copy of each node, and replaces those for which it returns true; returns
// true if there was any.
template <class Change>
bool change_nodes(Document& document, Change change) {
    std::vector<NodePtr> nodes(document.nodes.begin(), document.nodes.end());
    bool changed = false;
    for (NodePtr& node : nodes) {
        Node copy = copy_of(*node);
        if (!change(copy)) continue;
        mark_edited(copy);
        node = std::make_shared<const Node>(std::move(copy));
        changed = true;
    }
    if (changed) document.nodes = Table<NodePtr>(std::move(nodes));
    return changed;
}

// Changes links of inputs and outputs in the same way.
template <class Change>
bool change_links(Document& document, Change change) {
    const bool nodes_changed = change_nodes(document, [&](Node& node) {
        bool changed = false;
        for (Input& input : node.inputs)
            changed |= change(input);
        return changed;
    });
    std::vector<Output> outputs(document.outputs.begin(), document.outputs.end());
    bool outputs_changed = false;
    for (Output& output : outputs)
        outputs_changed |= change(output.from);
    if (outputs_changed) document.outputs = Table<Output>(std::move(outputs));
    return nodes_changed || outputs_changed;
}

// Removes the entries for which `dropped` is true; returns true if there was any.
template <class T, class Dropped>
bool erase_if(Table<T>& table, Dropped dropped) {
    std::vector<T> kept(table.begin(), table.end());
    if (std::erase_if(kept, dropped) == 0) return false;
    table = Table<T>(std::move(kept));
    return true;
}

bool upgrade_node(Node& node, const NodeUpgrade& upgrade) {
    bool changed = std::exchange(node.version, upgrade.version) != upgrade.version;
    for (const NodeUpgrade::Rename& rename : upgrade.inputs)
        for (Input& input : node.inputs) {
            if (input.port != rename.old_name || node.find(rename.new_name)) continue;
            input.port = rename.new_name;
            changed = true;
        }
    return changed;
}

bool upgrade_link(Input& input, const NodeUpgrade& upgrade) {
    std::string port = input.link.port;
    for (const NodeUpgrade::Rename& rename : upgrade.outputs)
        if (rename.old_name == port) port = rename.new_name;
    if (port == input.link.port) return false;
    editing::set_link(input, {input.link.node, port});
    return true;
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
    change_links(changed, [&](Input& input) {
        if (input.link.node != id) return false;
        editing::set_link(input, {std::string(new_id), input.link.port});
        return true;
    });
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
    change_nodes(changed, [&](Node& node) {
        return std::erase_if(node.inputs,
                             [&](const Input& input) { return ids.contains(input.link.node); }) > 0;
    });
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

Document mute_nodes(const Document& document, const std::set<std::string>& ids, bool muted) {
    Document changed = document;
    const auto mute = [&](Node& node) {
        return ids.contains(node.id) && std::exchange(node.muted, muted) != muted;
    };
    if (!change_nodes(changed, mute)) return document;
    mark_edited(changed);
    return changed;
}

Document upgrade_nodes(const Document& document, const std::vector<NodeUpgrade>& list) {
    std::unordered_map<std::string_view, const NodeUpgrade*> upgrades;
    for (const NodeUpgrade& upgrade : list)
        upgrades.emplace(upgrade.id, &upgrade);
    const auto upgrade_of = [&](const std::string& id) {
        const auto found = upgrades.find(id);
        return found == upgrades.end() ? nullptr : found->second;
    };
    Document changed = document;
    const bool nodes = change_nodes(changed, [&](Node& node) {
        const NodeUpgrade* upgrade = upgrade_of(node.id);
        return upgrade && upgrade_node(node, *upgrade);
    });
    const bool links = change_links(changed, [&](Input& input) {
        const NodeUpgrade* upgrade = input.link.is_node() ? upgrade_of(input.link.node) : nullptr;
        return upgrade && upgrade_link(input, *upgrade);
    });
    if (!nodes && !links) return document;
    mark_edited(changed);
    return changed;
}

bool would_cycle(const Document& document, const Link& from, std::string_view id) {
    return from.is_node() &&
           reachable(document, {from.node}, Direction::upstream).contains(std::string(id));
}

std::set<std::string> reachable(const Document& document, std::set<std::string> ids,
                                Direction direction) {
    const size_t count = document.nodes.size();
    const bool upstream = direction == Direction::upstream;
    std::vector<std::vector<uint32_t>> edges(count);
    const Wires wires(document);
    for (uint32_t i = 0; i < count; ++i)
        for (const uint32_t from : wires.of(i))
            if (from != Wires::none) edges[upstream ? i : from].push_back(upstream ? from : i);
    DepthFirst walk(count);
    for (const std::string& id : ids)
        if (const size_t start = document.nodes.index_of(id); start < count)
            walk.visit(
                static_cast<uint32_t>(start), [&](uint32_t node) { return edges[node].size(); },
                [&](uint32_t node, uint32_t edge) { return edges[node][edge]; },
                [](uint32_t, uint32_t, uint32_t) {});
    for (const uint32_t node : walk.order())
        ids.insert(document.nodes[node]->id);
    return ids;
}

}  // namespace wrinkle

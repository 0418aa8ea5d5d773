#include "difference/renames.h"

#include <algorithm>
#include <set>
#include <vector>

#include "base/text.h"
#include "json/write.h"

namespace wrinkle::difference {
namespace {

using ById = std::map<std::string, const Entry*>;

ById entries_only_in(const std::vector<Entry>& entries, const std::vector<Entry>& others) {
    std::set<std::string_view> known;
    for (const Entry& other : others)
        known.insert(other.id);
    ById found;
    for (const Entry& entry : entries)
        if (!known.contains(entry.id)) found.emplace(entry.id, &entry);
    return found;
}

// Equal for nodes with equal keys. Wires from nodes in `moved` have no source node: it may have
// been renamed too.
std::string signature(const Entry& node, const ById& moved) {
    std::vector<std::string> keys;
    for (const Key& key : node.keys) {
        const auto link = link_of(key.value);
        const bool is_open = link && moved.contains(link->node);
        keys.push_back((key.is_port ? "in " : "") + json_quoted(key.name) +
                       (is_open ? " ." + link->port : " " + json::one_line(key.value)));
    }
    std::ranges::sort(keys);
    return joined(keys, "\n");
}

// Nodes with this signature: their number and one of them.
struct Alike {
    size_t count = 0;
    std::string id;
};

std::map<std::string, Alike> by_signature(const ById& nodes) {
    std::map<std::string, Alike> alike;
    for (const auto& [id, node] : nodes) {
        Alike& entry = alike[signature(*node, nodes)];
        ++entry.count;
        entry.id = id;
    }
    return alike;
}

// Returns the renamed nodes that a pair of entries contradicts: a wire from one in `before` is not
// a wire from the new node in `after`.
void find_contradicted(const Entry& before, const Entry& after, const Renames& renames,
                       std::set<std::string>& contradicted) {
    for (const Key& key : before.keys) {
        const auto link = link_of(key.value);
        const auto renamed = link ? renames.find(link->node) : renames.end();
        if (renamed == renames.end()) continue;
        const Key* other = after.find(key);
        const auto new_link = other ? link_of(other->value) : std::nullopt;
        if (new_link != Link{renamed->second, link->port}) contradicted.insert(renamed->first);
    }
}

// Returns true if a renamed node has a wire to a node that is absent and not renamed: its new wire
// is another one.
bool has_other_wire(const Entry& node, const ById& deleted, const Renames& renames) {
    return std::ranges::any_of(node.keys, [&](const Key& key) {
        const auto link = link_of(key.value);
        return link && deleted.contains(link->node) && !renames.contains(link->node);
    });
}

std::set<std::string> all_contradicted(const Entries& before, const Entries& after,
                                       const ById& deleted, const Renames& renames) {
    std::set<std::string> contradicted;
    for (const Section section : {Section::nodes, Section::outputs}) {
        std::map<std::string_view, const Entry*> new_entries;
        for (const Entry& entry : after[section])
            new_entries.emplace(entry.id, &entry);
        for (const Entry& entry : before[section]) {
            const auto renamed = section == Section::nodes ? renames.find(entry.id) : renames.end();
            if (renamed != renames.end() && has_other_wire(entry, deleted, renames))
                contradicted.insert(entry.id);
            const auto found =
                new_entries.find(renamed == renames.end() ? entry.id : renamed->second);
            if (found != new_entries.end())
                find_contradicted(entry, *found->second, renames, contradicted);
        }
    }
    return contradicted;
}

}  // namespace

Renames find_renames(const Entries& before, const Entries& after) {
    const ById deleted = entries_only_in(before[Section::nodes], after[Section::nodes]);
    const ById added = entries_only_in(after[Section::nodes], before[Section::nodes]);
    const auto old_nodes = by_signature(deleted), new_nodes = by_signature(added);
    Renames renames;
    for (const auto& [content, node] : old_nodes) {
        const auto found = new_nodes.find(content);
        if (node.count == 1 && found != new_nodes.end() && found->second.count == 1)
            renames.emplace(node.id, found->second.id);
    }
    for (;;) {
        const auto contradicted = all_contradicted(before, after, deleted, renames);
        if (contradicted.empty()) return renames;
        for (const std::string& id : contradicted)
            renames.erase(id);
    }
}

}  // namespace wrinkle::difference

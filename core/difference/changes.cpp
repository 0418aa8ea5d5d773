#include "difference/changes.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "difference/renames.h"
#include "graph/edit.h"
#include "graph/write.h"

namespace wrinkle::difference {
namespace {

using Index = std::map<std::string_view, const Entry*>;

Index index_of(const std::vector<Entry>& entries) {
    Index index;
    for (const Entry& entry : entries)
        index.emplace(entry.id, &entry);
    return index;
}

void add_keys(Section section, const Entry& before, const Entry& after,
              std::vector<Change>& changes) {
    const auto add = [&](const Key& key, const json::Value& a, const json::Value& b) {
        changes.push_back(
            {section, ChangeKind::changed, after.id, "", {key.is_port, key.name, {}}, a, b});
    };
    for (const Key& key : before.keys) {
        const Key* other = after.find(key);
        if (!other)
            add(key, key.value, {});
        else if (!(other->value == key.value))
            add(key, key.value, other->value);
    }
    for (const Key& key : after.keys)
        if (!before.find(key)) add(key, {}, key.value);
}

void add_section(Section section, const Entries& before, const Entries& after,
                 std::vector<Change>& changes) {
    const Index old_entries = index_of(before[section]), new_entries = index_of(after[section]);
    for (const auto& [id, entry] : old_entries) {
        const auto found = new_entries.find(id);
        if (found == new_entries.end())
            changes.push_back(
                {section, ChangeKind::removed, std::string(id), "", {}, entry->value, {}});
        else if (entry->is_single != found->second->is_single)
            changes.push_back({section,
                               ChangeKind::changed,
                               std::string(id),
                               "",
                               {},
                               entry->value,
                               found->second->value});
        else
            add_keys(section, *entry, *found->second, changes);
    }
    for (const auto& [id, entry] : new_entries)
        if (!old_entries.contains(id))
            changes.push_back(
                {section, ChangeKind::added, std::string(id), "", {}, {}, entry->value});
}

// Compares the order of the entries that both have.
bool is_reordered(const std::vector<Entry>& before, const std::vector<Entry>& after) {
    const Index old_entries = index_of(before), new_entries = index_of(after);
    const auto common = [](const std::vector<Entry>& entries, const Index& others) {
        std::vector<std::string_view> ids;
        for (const Entry& entry : entries)
            if (others.contains(entry.id)) ids.push_back(entry.id);
        return ids;
    };
    return common(before, new_entries) != common(after, old_entries);
}

bool comes_first(const Change& a, const Change& b) {
    return std::tie(a.section, a.id, a.kind) < std::tie(b.section, b.id, b.kind);
}

}  // namespace

Changes changes_between(const Document& before, const Document& after) {
    Changes changes;
    changes.same_bytes = write_document(before) == write_document(after);
    Document renamed = before;
    const Entries new_entries = entries_of(after);
    for (const auto& [id, new_id] : find_renames(entries_of(before), new_entries)) {
        changes.material.push_back({Section::nodes, ChangeKind::renamed, id, new_id, {}, {}, {}});
        renamed = rename_node(renamed, id, new_id);
    }
    const Entries old_entries = entries_of(renamed);
    for (size_t i = 0; i < section_names.size(); ++i) {
        const auto section = static_cast<Section>(i);
        add_section(section, old_entries, new_entries,
                    is_layout(section) ? changes.layout : changes.material);
        changes.reordered |= is_reordered(old_entries[section], new_entries[section]);
    }
    std::ranges::stable_sort(changes.material, comes_first);
    return changes;
}

}  // namespace wrinkle::difference

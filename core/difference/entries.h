// Difference of two graphs, by names and not by lines. A graph is seen as sections of entries: an
// entry is a node, a graph input, a preset, an output, or a part of the layout, and has an id. Its
// keys have values: a node has "type", "version", "muted" and a value or wire for each port. Two
// graphs differ in the entries that only one of them has, and in keys with different values.
// Differences (changes.h), merges (merge.h) and conflicts (conflicts.h) are lists of such entries
// and keys. Positions, frames and notes are the layout: the material does not depend on them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/document.h"

namespace wrinkle::difference {

// `graph`: top-level keys such as "name" and "back_faces".
enum class Section : uint8_t { graph, inputs, presets, nodes, outputs, positions, frames, notes };
inline constexpr std::array<std::string_view, 8> section_names = {
    "graph", "inputs", "presets", "nodes", "outputs", "positions", "frames", "notes"};
// Singular, for messages.
inline constexpr std::array<std::string_view, 8> entry_names = {
    "graph", "input", "preset", "node", "output", "position", "frame", "note"};
inline bool is_layout(Section section) {
    return section >= Section::positions;
}

struct Key {
    bool is_port = false;  // a member of a node's "in"
    std::string name;
    json::Value value;

    bool same_name(const Key& other) const {
        return is_port == other.is_port && name == other.name;
    }
};

struct Entry {
    std::string id;
    bool is_single = false;  // one value without keys: `keys` has one without a name
    std::vector<Key> keys;
    json::Value value;  // as JSON; not set in the entries of a merge

    const Key* find(const Key& key) const;  // by same_name(); null: none
};

// Compares keys and values in any order, not ids.
bool operator==(const Entry& a, const Entry& b);

struct Entries {
    std::array<std::vector<Entry>, section_names.size()> sections;

    std::vector<Entry>& operator[](Section section) { return sections[size_t(section)]; }
    const std::vector<Entry>& operator[](Section section) const {
        return sections[size_t(section)];
    }
};
const Entry* find_entry(const std::vector<Entry>& entries, std::string_view id);

// Returns the reason why a document has no entries (it was not read to its end, or a section is
// not an object); "" if it has.
std::string entries_fault(const Document& document);

// Precondition: entries_fault() is "".
Entries entries_of(const Document& document);

// Returns the entries as canonical text of a graph (graph/write.h).
std::string graph_text(const Entries& entries);

// Returns an entry from its value as JSON.
Entry entry_of(Section section, std::string_view id, const json::Value& value);
// Returns the keys as one JSON object on one line; of a single value that value.
std::string entry_text(const Entry& entry);

// Returns the source of a wire, {"from": "node.port"}; std::nullopt for another value.
std::optional<Link> link_of(const json::Value& value);

}  // namespace wrinkle::difference

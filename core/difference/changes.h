// Changes from one graph to another, as a list and as text.
#pragma once

#include <string>
#include <vector>

#include "difference/entries.h"

namespace wrinkle::difference {

enum class ChangeKind : uint8_t { added, removed, renamed, changed };

struct Change {
    Section section = Section::graph;
    ChangeKind kind = ChangeKind::changed;
    std::string id;      // in `after`; of removed and renamed entries, in `before`
    std::string new_id;  // if renamed
    Key key;             // if changed, without its value; no name: a side has no keys
    // Absent: a Value without tree(). Of added and removed entries the entries as JSON.
    json::Value before, after;
};

struct Changes {
    std::vector<Change> material;  // by section, then by id
    std::vector<Change> layout;    // of the layout: by section, the added ones last
    bool reordered = false;        // entries of a section have another order in the file
    bool same_bytes = false;       // the files are equal

    bool same_material() const { return material.empty(); }
};

// Precondition: entries_fault() of both is "".
Changes changes_between(const Document& before, const Document& after);

// One line per change of the material and one for the layout.
std::vector<std::string> change_lines(const Changes& changes);
// "same", "other text, same material", "other layout, same material" or "different".
std::string verdict(const Changes& changes);
// All lines, the last the verdict.
std::string changes_text(const Changes& changes);
// {"version": 1, "same": true, "same_bytes", "changes": [{"section", "id", "change", ...}],
//  "layout": [...], "reordered"}, and `members`: name and JSON of each.
struct JsonMember {
    std::string name, value;
};
std::string changes_json(const Changes& changes, const std::vector<JsonMember>& members = {});

// Lists a graph as one line per key of an entry, sorted by id, without the layout.
std::string listing(const Document& document);

// Returns a value as in messages: a wire as node.port, an absent one as "unset".
std::string value_text(const json::Value& value, bool is_absent);

// Returns "node weave.scale", "node weave: type", "output normal".
std::string key_text(Section section, std::string_view id, const Key& key);

}  // namespace wrinkle::difference

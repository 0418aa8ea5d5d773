// Conflicts of a merge, their file, and their resolution by the value of one side.
//
// NAME.json.conflicts lists the open conflicts of NAME.json, which is a valid graph:
// {"wrinkle_conflicts": 1, "conflicts": [{"kind", "section", "id", "port" or "key", "base", "ours",
// "theirs", "message"}]}. An absent value is absent there too; of entries the values are entries.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "difference/entries.h"

namespace wrinkle::difference {

enum class ConflictKind : uint8_t {
    both_changed,       // a key, or an entry that is one value
    both_added,         // an entry with other content on each side
    deleted_by_ours,    // and changed by theirs
    deleted_by_theirs,  // and changed by ours
    renamed,            // to another id on each side: `id` by ours, the string `theirs` by theirs
    error,              // only the result has it: `message`
};
inline constexpr std::array<std::string_view, 6> conflict_kinds = {
    "both changed", "both added", "deleted by ours", "deleted by theirs", "renamed", "error"};

struct Conflict {
    ConflictKind kind = ConflictKind::both_changed;
    Section section = Section::nodes;
    std::string id;  // "" for an error without a node
    Key key;         // without its value; no name: the entry
    std::optional<json::Value> base, ours, theirs;
    std::string message;
};

// Returns a sentence: "node weave.scale: 16 in ours, 4 in theirs; it was 8".
std::string sentence_of(const Conflict& conflict);

inline constexpr std::string_view conflicts_suffix = ".conflicts";
std::string conflicts_text(const std::vector<Conflict>& conflicts);
// Reports errors and returns std::nullopt if the text is not such a list.
std::optional<std::vector<Conflict>> read_conflicts(std::string text, std::string file,
                                                    Diagnostics& diagnostics);

enum class Side : uint8_t { ours, theirs };

// Returns the text of the graph with one side's value or entry. Precondition: the conflict is not
// an error; entries_fault() is "".
std::string with_side(const Document& document, const Conflict& conflict, Side side);

}  // namespace wrinkle::difference

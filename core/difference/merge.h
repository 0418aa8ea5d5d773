// Three-way merge of a graph: the changes of two sides since their common base, by id and key.
//
// Per entry: added on one side: added; on both: if equal, once. Deleted on one side and unchanged
// on the other: deleted. Else per key: changed on one side: that value; on both to equal values:
// once. Everything else is a conflict: the result then has the value of `ours`, and an entry that
// one side deleted and the other changed remains in it. A renamed node (renames.h) takes the other
// side's changes. A deleted node has no position, and positions and rectangles of the layout do not
// conflict: those of `ours` win. The order is that of `ours`; if only `theirs` reordered, of
// `theirs`. An error that the result has and neither side had, such as a cycle of two wires, is a
// conflict too.
#pragma once

#include <string>
#include <vector>

#include "difference/conflicts.h"
#include "difference/entries.h"

namespace wrinkle::difference {

struct Merged {
    // Bytes of a side that has all of the result, else canonical text.
    std::string text;
    std::vector<Conflict> conflicts;
    Document ours, theirs;  // the sides with the ids of the result, to compare their errors
};

enum class MergePurpose : uint8_t {
    result,
    // The result is a base of another merge (Git merges several common ancestors to one). An entry
    // or value in conflict is an array that begins with "conflict", so it equals that of no side.
    ancestor,
};

// Precondition: entries_fault() of all is "".
Merged merge(const Document& base, const Document& ours, const Document& theirs,
             MergePurpose purpose = MergePurpose::result);

// Appends a conflict for each error of `result` that is not in `ours` or `theirs`.
void add_new_errors(const Diagnostics& ours, const Diagnostics& theirs, const Diagnostics& result,
                    std::vector<Conflict>& conflicts);

}  // namespace wrinkle::difference

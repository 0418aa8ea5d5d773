// Difference between a snapshot and the next, applicable in both directions. It stores only the
// entries that differ, so the memory of a history is proportional to the edits, not to the
// documents.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "graph/document.h"

namespace wrinkle::editor {

// Returns true if two snapshots share everything that an edit can change.
bool same_document(const Document& a, const Document& b);

// Runs of table entries that were replaced by others, in table order. An entry is unchanged if it
// is shared or equal.
template <class T>
struct TableDelta {
    struct Run {
        size_t at = 0;  // index in the table before the edit
        std::vector<T> before, after;
    };
    std::vector<Run> runs;
};

class Delta {
public:
    Delta() = default;  // changes nothing
    Delta(const Document& before, const Document& after);

    // Return the other snapshot; unchanged entries are shared with the given one. Precondition: the
    // argument equals the snapshot given to the constructor. O(table entries).
    Document forward(const Document& before) const;
    Document backward(const Document& after) const;

private:
    // Fields that are not table entries.
    struct Head {
        std::string name;
        std::optional<BackFaces> back_faces;
        bool edited = false;
    };
    struct Tables {
        TableDelta<NodePtr> nodes;
        TableDelta<GraphInput> inputs;
        TableDelta<Output> outputs;
        TableDelta<Position> positions;
        TableDelta<Box> frames, notes;
    };
    Head heads_[2];  // before, after
    std::shared_ptr<const Tables> tables_;
    // Both complete snapshots if their source text, lost parts or file differ; tables_ is
    // null then.
    std::shared_ptr<const std::pair<Document, Document>> whole_;

    Document apply(const Document& from, bool back) const;
};

}  // namespace wrinkle::editor

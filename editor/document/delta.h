// What one edit changed, both ways: from a snapshot to the next and back. It holds the entries that
// differ, so that a history of any length costs what was edited and not what was there.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "graph/document.h"

namespace wrinkle::editor {

// Whether two snapshots share everything that an edit can change.
bool same_document(const Document& a, const Document& b);

// Entries of a table that were replaced by others, in the order of the table. An entry counts as
// unchanged when it is shared or equal.
template <class T>
struct TableDelta {
    struct Run {
        size_t at = 0;  // in the table before
        std::vector<T> before, after;
    };
    std::vector<Run> runs;
};

class Delta {
public:
    Delta() = default;  // changes nothing
    Delta(const Document& before, const Document& after);

    // The snapshot at the other end; what was not changed is shared with the one given.
    Document forward(const Document& before) const;
    Document backward(const Document& after) const;

private:
    // What is not an entry of a table.
    struct Head {
        std::string name;
        BackFaces back_faces = BackFaces::mirror;
        bool edited = false;
    };
    struct Tables {
        TableDelta<NodePtr> nodes;
        TableDelta<GraphInput> inputs;
        TableDelta<Output> outputs;
        TableDelta<Position> positions;
        TableDelta<Box> frames, notes;
    };
    Head heads_[2];
    std::shared_ptr<const Tables> tables_;
    // Of two snapshots that were read from different texts: both whole.
    std::shared_ptr<const std::pair<Document, Document>> whole_;

    Document apply(const Document& from, bool back) const;
};

}  // namespace wrinkle::editor

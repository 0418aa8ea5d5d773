// Undo stack of one document: the current snapshot and the difference made by each step; its length
// is unlimited.
//
// Undo and redo move along the steps; a commit drops the undone ones. Successive commits with the
// same `merge` key are merged into one step: a drag commits on every frame and is undone at once.
// Every state of the document has its own serial number. A step stores the span of nodes and of
// positions that changed; the smaller tables are snapshots.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "editor/model/document/change.h"

namespace wrinkle::editor {

// Entries of a table that replace others, from index `at` on.
template <class T>
struct Replacement {
    size_t at = 0;
    std::vector<T> before, after;
};

class History {
public:
    explicit History(Document document = {});

    const Document& now() const { return now_; }
    uint64_t serial() const { return steps_[at_].serial; }

    // Returns false without effect if the document is equal to the current one.
    bool commit(std::string name, Document document, const std::string& merge = {});
    // Replaces the nodes of all states by `change(node)`, which does not change ids. No step is
    // made.
    void replace_nodes(const std::function<NodePtr(const NodePtr&)>& change);
    // Removes the newest step if it has this key; it cannot be redone.
    void cancel(const std::string& merge);

    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < steps_.size(); }
    bool undo();
    bool redo();
    const std::string& undo_name() const { return steps_[at_].name; }      // if can_undo()
    const std::string& redo_name() const { return steps_[at_ + 1].name; }  // if can_redo()

    // All steps from the first, "Open", on; `at` is the index of the current one.
    size_t size() const { return steps_.size(); }
    size_t at() const { return at_; }
    const std::string& name(size_t step) const { return steps_[step].name; }
    // Returns the inputs of the graph in the state with this serial; nullptr if it is gone.
    const Table<GraphInput>* inputs_at(uint64_t serial) const;
    // Returns true if commits with the same key can still merge into the current step.
    bool merging() const { return !steps_[at_].merge.empty() && !can_redo(); }

private:
    struct Step {
        std::string name;  // "Scale: amount"
        std::string merge;
        uint64_t serial = 0;
        Document rest;                    // the state without nodes and positions
        Replacement<NodePtr> nodes;       // since the previous step
        Replacement<Position> positions;  // since the previous step
    };
    void go(const Step& step, size_t to);

    Document now_;
    std::vector<Step> steps_;
    size_t at_ = 0;
    uint64_t next_serial_ = 1;
};

}  // namespace wrinkle::editor

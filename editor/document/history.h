// The edits of one document as a list of immutable snapshots, with what each step did.
//
// Undo and redo move along the list; a commit drops what was undone. Steps that carry the same
// `merge` key and follow each other are one step: a drag commits on every frame and is undone at
// once. Every state that the document was ever in has its own serial number.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "graph/document.h"

namespace wrinkle::editor {

// Whether two snapshots share everything that an edit can change.
bool same_document(const Document& a, const Document& b);

class History {
public:
    static constexpr size_t max_steps = 4096;  // the oldest are forgotten

    explicit History(Document document = {});

    const Document& now() const { return steps_[at_].document; }
    uint64_t serial() const { return steps_[at_].serial; }

    // False, and nothing happens, when the document is the present one.
    bool commit(std::string name, Document document, const std::string& merge = {});
    // Takes back the newest step if it carries this key; it cannot be redone.
    void cancel(const std::string& merge);

    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < steps_.size(); }
    bool undo();
    bool redo();
    const std::string& undo_name() const { return steps_[at_].name; }      // if can_undo()
    const std::string& redo_name() const { return steps_[at_ + 1].name; }  // if can_redo()

private:
    struct Step {
        std::string name;  // "Scale: amount"
        std::string merge;
        Document document;
        uint64_t serial = 0;
    };
    std::vector<Step> steps_;
    size_t at_ = 0;
    uint64_t next_serial_ = 1;
};

}  // namespace wrinkle::editor

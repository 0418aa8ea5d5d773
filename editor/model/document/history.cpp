#include "editor/model/document/history.h"

namespace wrinkle::editor {

History::History(Document document) : now_(std::move(document)) {
    steps_.push_back({"Open", {}, 0, {}});
}

bool History::commit(std::string name, Document document, const std::string& merge) {
    if (same_document(now_, document)) return false;
    steps_.resize(at_ + 1);
    const bool merges = !merge.empty() && steps_.back().merge == merge;
    if (merges) {
        now_ = steps_.back().delta.backward(now_);
        steps_.pop_back();
    }
    steps_.push_back({std::move(name), merge, next_serial_++, Delta(now_, document)});
    now_ = std::move(document);
    at_ = steps_.size() - 1;
    return true;
}

void History::cancel(const std::string& merge) {
    if (merge.empty() || at_ == 0 || steps_[at_].merge != merge) return;
    undo();
    steps_.resize(at_ + 1);
}

bool History::undo() {
    if (!can_undo()) return false;
    now_ = steps_[at_--].delta.backward(now_);
    return true;
}

bool History::redo() {
    if (!can_redo()) return false;
    now_ = steps_[++at_].delta.forward(now_);
    return true;
}

}  // namespace wrinkle::editor

#include "editor/document/history.h"

namespace wrinkle::editor {

bool same_document(const Document& a, const Document& b) {
    return a.nodes.same(b.nodes) && a.inputs.same(b.inputs) && a.outputs.same(b.outputs) &&
           a.positions.same(b.positions) && a.frames.same(b.frames) && a.notes.same(b.notes) &&
           a.name == b.name && a.back_faces == b.back_faces;
}

History::History(Document document) {
    steps_.push_back({"Open", {}, std::move(document), 0});
}

bool History::commit(std::string name, Document document, const std::string& merge) {
    if (same_document(now(), document)) return false;
    steps_.resize(at_ + 1);
    const bool merges = !merge.empty() && steps_.back().merge == merge;
    if (merges) steps_.pop_back();
    steps_.push_back({std::move(name), merge, std::move(document), next_serial_++});
    if (steps_.size() > max_steps) steps_.erase(steps_.begin());
    at_ = steps_.size() - 1;
    return true;
}

void History::cancel(const std::string& merge) {
    if (at_ == 0 || steps_[at_].merge != merge) return;
    steps_.resize(at_);
    --at_;
}

bool History::undo() {
    if (!can_undo()) return false;
    --at_;
    return true;
}

bool History::redo() {
    if (!can_redo()) return false;
    ++at_;
    return true;
}

}  // namespace wrinkle::editor

#include "editor/model/document/history.h"

#include <algorithm>
#include <iterator>

namespace wrinkle::editor {
namespace {

bool same_entry(const NodePtr& a, const NodePtr& b) {
    return a == b;
}
bool same_entry(const Position& a, const Position& b) {
    return a.x == b.x && a.y == b.y && a.source.same(b.source) && a.id == b.id;
}

template <class T>
Replacement<T> difference(const Table<T>& before, const Table<T>& after) {
    if (before.same(after)) return {};
    const auto same = [](const T& a, const T& b) { return same_entry(a, b); };
    const auto [from, from_after] =
        std::mismatch(before.begin(), before.end(), after.begin(), after.end(), same);
    const auto [end, end_after] =
        std::mismatch(std::reverse_iterator(before.end()), std::reverse_iterator(from),
                      std::reverse_iterator(after.end()), std::reverse_iterator(from_after), same);
    return {static_cast<size_t>(from - before.begin()),
            {from, end.base()},
            {from_after, end_after.base()}};
}

template <class T>
Table<T> replaced(const Table<T>& table, const Replacement<T>& by, bool back) {
    const std::vector<T>& from = back ? by.after : by.before;
    const std::vector<T>& to = back ? by.before : by.after;
    if (from.empty() && to.empty()) return table;
    std::vector<T> items(table.begin(), table.begin() + by.at);
    items.insert(items.end(), to.begin(), to.end());
    items.insert(items.end(), table.begin() + by.at + from.size(), table.end());
    const bool same_keys =
        std::equal(from.begin(), from.end(), to.begin(), to.end(),
                   [](const T& a, const T& b) { return table_key(a) == table_key(b); });
    return same_keys ? table.with_same_keys(std::move(items)) : Table<T>(std::move(items));
}

Document rest_of(Document document) {
    document.nodes = {};
    document.positions = {};
    return document;
}

}  // namespace

History::History(Document document) : now_(std::move(document)) {
    steps_.push_back({"Open", {}, 0, rest_of(now_), {}, {}});
}

bool History::commit(std::string name, Document document, const std::string& merge) {
    if (same_document(now_, document)) return false;
    steps_.resize(at_ + 1);
    cancel(merge);
    steps_.push_back({std::move(name), merge, next_serial_++, rest_of(document),
                      difference(now_.nodes, document.nodes),
                      difference(now_.positions, document.positions)});
    now_ = std::move(document);
    at_ = steps_.size() - 1;
    return true;
}

void History::replace_nodes(const std::function<NodePtr(const NodePtr&)>& change) {
    std::vector<NodePtr> nodes(now_.nodes.begin(), now_.nodes.end());
    std::ranges::transform(nodes, nodes.begin(), change);
    if (!std::ranges::equal(nodes, now_.nodes))
        now_.nodes = now_.nodes.with_same_keys(std::move(nodes));
    for (Step& step : steps_) {
        std::ranges::transform(step.nodes.before, step.nodes.before.begin(), change);
        std::ranges::transform(step.nodes.after, step.nodes.after.begin(), change);
    }
}

const Table<GraphInput>* History::inputs_at(uint64_t serial) const {
    const auto step = std::ranges::find(steps_, serial, &Step::serial);
    return step == steps_.end() ? nullptr : &step->rest.inputs;
}

void History::cancel(const std::string& merge) {
    if (merge.empty() || steps_[at_].merge != merge) return;
    undo();
    steps_.resize(at_ + 1);
}

bool History::undo() {
    if (!can_undo()) return false;
    go(steps_[at_], at_ - 1);
    return true;
}

bool History::redo() {
    if (!can_redo()) return false;
    go(steps_[at_ + 1], at_ + 1);
    return true;
}

// Moves to the adjacent state `to` along `step`.
void History::go(const Step& step, size_t to) {
    Document next = steps_[to].rest;
    next.nodes = replaced(now_.nodes, step.nodes, to < at_);
    next.positions = replaced(now_.positions, step.positions, to < at_);
    now_ = std::move(next);
    at_ = to;
}

}  // namespace wrinkle::editor

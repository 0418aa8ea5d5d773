#include "editor/model/document/delta.h"

#include <algorithm>

namespace wrinkle::editor {
namespace {

bool same_extras(const std::vector<Extra>& a, const std::vector<Extra>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Extra& x, const Extra& y) {
        return x.key == y.key && x.value.same(y.value);
    });
}

bool same_entry(const NodePtr& a, const NodePtr& b) {
    return a == b;
}
bool same_entry(const GraphInput& a, const GraphInput& b) {
    return a.name == b.name && a.type == b.type && a.default_value.same(b.default_value) &&
           a.doc == b.doc && a.source.same(b.source) && same_extras(a.unknown, b.unknown);
}
bool same_entry(const Output& a, const Output& b) {
    return a.name == b.name && a.from.port == b.from.port && a.from.kind == b.from.kind &&
           a.from.link == b.from.link && a.from.value.same(b.from.value);
}
bool same_entry(const Position& a, const Position& b) {
    return a.x == b.x && a.y == b.y && a.source.same(b.source) && a.id == b.id;
}
bool same_entry(const Box& a, const Box& b) {
    return a.id == b.id && a.text == b.text && a.rect == b.rect && a.source.same(b.source) &&
           same_extras(a.unknown, b.unknown);
}

// Compares both tables in parallel. An entry with a key that the other side lacks was removed or
// added; from the first entry that was moved on, everything is replaced.
template <class T>
class TableComparison {
public:
    TableComparison(const Table<T>& before, const Table<T>& after)
        : before_(before), after_(after) {}

    TableDelta<T> run() {
        if (before_.same(after_)) return {};
        while (i_ < before_.size() || j_ < after_.size())
            step();
        return std::move(delta_);
    }

private:
    void step() {
        const bool more = i_ < before_.size(), more_after = j_ < after_.size();
        if (more && more_after && same_entry(before_[i_], after_[j_])) {
            ++i_, ++j_;
            open_ = false;
            return;
        }
        const bool removed = more && after_.index_of(table_key(before_[i_])) == Table<T>::npos;
        const bool added = more_after && before_.index_of(table_key(after_[j_])) == Table<T>::npos;
        const bool replaced = more && more_after && table_key(before_[i_]) == table_key(after_[j_]);
        if (removed || replaced) take_before();
        if (added || replaced) take_after();
        if (removed || added || replaced) return;
        while (i_ < before_.size())
            take_before();
        while (j_ < after_.size())
            take_after();
    }

    typename TableDelta<T>::Run& current() {
        if (!open_) delta_.runs.push_back({i_, {}, {}});
        open_ = true;
        return delta_.runs.back();
    }
    void take_before() {
        auto& run = current();
        run.before.push_back(before_[i_++]);
    }
    void take_after() { current().after.push_back(after_[j_++]); }

    const Table<T>& before_;
    const Table<T>& after_;
    TableDelta<T> delta_;
    size_t i_ = 0, j_ = 0;
    bool open_ = false;
};

template <class T>
TableDelta<T> difference(const Table<T>& before, const Table<T>& after) {
    return TableComparison<T>(before, after).run();
}

template <class T>
void apply_to(Table<T>& table, const TableDelta<T>& delta, bool back) {
    if (delta.runs.empty()) return;
    std::vector<T> items;
    items.reserve(table.size() + 1);
    size_t next = 0;       // index in the given table
    size_t before_at = 0;  // corresponding index in the table before the edit
    bool same_keys = true;
    for (const auto& run : delta.runs) {
        const size_t shared = run.at - before_at;
        items.insert(items.end(), table.begin() + next, table.begin() + next + shared);
        const std::vector<T>& old_items = back ? run.after : run.before;
        const std::vector<T>& new_items = back ? run.before : run.after;
        items.insert(items.end(), new_items.begin(), new_items.end());
        same_keys = same_keys && std::equal(old_items.begin(), old_items.end(), new_items.begin(),
                                            new_items.end(), [](const T& a, const T& b) {
                                                return table_key(a) == table_key(b);
                                            });
        next += shared + old_items.size();
        before_at = run.at + run.before.size();
    }
    items.insert(items.end(), table.begin() + next, table.end());
    table = same_keys ? table.with_same_keys(std::move(items)) : Table<T>(std::move(items));
}

}  // namespace

bool same_document(const Document& a, const Document& b) {
    return a.nodes.same(b.nodes) && a.inputs.same(b.inputs) && a.outputs.same(b.outputs) &&
           a.positions.same(b.positions) && a.frames.same(b.frames) && a.notes.same(b.notes) &&
           a.name == b.name && a.back_faces == b.back_faces;
}

Delta::Delta(const Document& before, const Document& after)
    : heads_{{before.name, before.back_faces, before.edited},
             {after.name, after.back_faces, after.edited}} {
    if (!before.source.same(after.source) || before.lost != after.lost ||
        before.file != after.file) {
        whole_ = std::make_shared<const std::pair<Document, Document>>(before, after);
        return;
    }
    Tables tables;
    tables.nodes = difference(before.nodes, after.nodes);
    tables.inputs = difference(before.inputs, after.inputs);
    tables.outputs = difference(before.outputs, after.outputs);
    tables.positions = difference(before.positions, after.positions);
    tables.frames = difference(before.frames, after.frames);
    tables.notes = difference(before.notes, after.notes);
    tables_ = std::make_shared<const Tables>(std::move(tables));
}

Document Delta::forward(const Document& before) const {
    return apply(before, false);
}

Document Delta::backward(const Document& after) const {
    return apply(after, true);
}

Document Delta::apply(const Document& from, bool back) const {
    if (whole_) return back ? whole_->first : whole_->second;
    Document result = from;
    if (!tables_) return result;
    const Head& head = heads_[back ? 0 : 1];
    result.name = head.name;
    result.back_faces = head.back_faces;
    result.edited = head.edited;
    apply_to(result.nodes, tables_->nodes, back);
    apply_to(result.inputs, tables_->inputs, back);
    apply_to(result.outputs, tables_->outputs, back);
    apply_to(result.positions, tables_->positions, back);
    apply_to(result.frames, tables_->frames, back);
    apply_to(result.notes, tables_->notes, back);
    return result;
}

}  // namespace wrinkle::editor

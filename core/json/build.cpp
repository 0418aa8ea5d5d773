// Construction of values. Each built value has a separate tree, into which the children's trees are
// copied: linear in all descendants.
#include <cassert>
#include <cmath>

#include "base/text.h"
#include "json/tree.h"

namespace wrinkle::json {
namespace {

void add_text(Tree& tree, Kind kind, std::string_view text, uint32_t parent) {
    Entry entry;
    entry.kind = kind;
    entry.place = static_cast<uint32_t>(tree.pool.size());
    entry.length = static_cast<uint32_t>(text.size());
    entry.parent = parent;
    entry.pooled = true;
    tree.pool += text;
    tree.entries.push_back(entry);
}

// Appends a copy of the value's sub-tree; all texts go to the pool, because offsets refer to the
// source of the old tree.
void add_copy(Tree& tree, const Value& value, uint32_t parent) {
    const Tree* from = value.tree().get();
    const uint32_t begin = value.index();
    const uint32_t end = from ? from->after(begin) : begin + 1;
    const auto to = static_cast<uint32_t>(tree.entries.size());
    for (uint32_t i = begin; i < end; ++i) {
        Entry entry = from ? from->entries[i] : Entry{};
        if (is_container(entry.kind)) {
            entry.place += to - begin;
        } else if (from) {
            const std::string_view text = from->text(entry);
            entry.place = static_cast<uint32_t>(tree.pool.size());
            entry.pooled = true;
            tree.pool += text;
        }
        entry.offset = 0;
        entry.parent = i == begin ? parent : entry.parent - begin + to;
        if (i == begin) entry.duplicate = false;
        tree.entries.push_back(entry);
    }
}

Value built(Tree tree) {
    return {std::make_shared<const Tree>(std::move(tree)), 0};
}

Value built(Kind kind, std::string_view text) {
    Tree tree;
    add_text(tree, kind, text, 0);
    return built(std::move(tree));
}

Tree container(Kind kind, size_t size) {
    Tree tree;
    tree.entries.emplace_back();
    tree.entries[0].kind = kind;
    tree.entries[0].length = static_cast<uint32_t>(size);
    return tree;
}

Value closed(Tree tree) {
    tree.entries[0].place = static_cast<uint32_t>(tree.entries.size());
    return built(std::move(tree));
}

}  // namespace

Value Value::boolean(bool value) {
    Tree tree;
    tree.entries.emplace_back();
    tree.entries[0].kind = Kind::boolean;
    tree.entries[0].truth = value;
    return closed(std::move(tree));
}

Value Value::number(double value) {
    assert(std::isfinite(value));
    return built(Kind::number, shortest(value));
}

Value Value::single(float value) {
    assert(std::isfinite(value));
    return built(Kind::number, shortest(value));
}

Value Value::string(std::string_view text) {
    return built(Kind::string, text);
}

Value Value::array(std::span<const Value> items) {
    Tree tree = container(Kind::array, items.size());
    for (const Value& item : items)
        add_copy(tree, item, 0);
    return closed(std::move(tree));
}

Value Value::array(std::initializer_list<Value> items) {
    return array(std::span<const Value>(items.begin(), items.size()));
}

Value Value::object(std::span<const std::pair<std::string, Value>> members) {
    Tree tree = container(Kind::object, members.size());
    for (const auto& [key, value] : members) {
        add_text(tree, Kind::string, key, 0);
        add_copy(tree, value, 0);
    }
    return closed(std::move(tree));
}

}  // namespace wrinkle::json

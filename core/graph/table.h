// Immutable ordered table with hash lookup by key.
//
// Lookup is O(1) on average. Copies are O(1) and share their contents; `with` and `without` return
// a changed copy, O(n) (the index is shared if an entry is replaced). Keys should be unique: of
// equal keys the first is found. An entry type defines `std::string_view table_key(const T&)` in
// its namespace.
#pragma once

#include <bit>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wrinkle {

template <class T>
class Table {
public:
    Table() = default;
    explicit Table(std::vector<T> items)
        : items_(std::make_shared<const std::vector<T>>(std::move(items))),
          slots_(index(*items_)) {}

    size_t size() const { return items_ ? items_->size() : 0; }
    bool empty() const { return size() == 0; }
    const T& operator[](size_t i) const { return (*items_)[i]; }
    const T* begin() const { return items_ ? items_->data() : nullptr; }
    const T* end() const { return begin() + size(); }

    static constexpr size_t npos = ~size_t{0};

    size_t index_of(std::string_view key) const {
        if (empty()) return npos;
        const size_t slot = probe(*items_, *slots_, key);
        return (*slots_)[slot] == 0 ? npos : (*slots_)[slot] - 1;
    }
    const T* find(std::string_view key) const {
        const size_t i = index_of(key);
        return i == npos ? nullptr : begin() + i;
    }

    // Replaces the entry with the same key at its position, or appends.
    Table with(T item) const {
        std::vector<T> items(begin(), end());
        const size_t i = index_of(table_key(item));
        if (i == npos) {
            items.push_back(std::move(item));
            return Table(std::move(items));
        }
        items[i] = std::move(item);
        return with_same_keys(std::move(items));
    }
    // Returns a table of `items` that shares this table's index. Precondition: the items have the
    // same keys in the same order.
    Table with_same_keys(std::vector<T> items) const {
        Table changed;
        changed.items_ = std::make_shared<const std::vector<T>>(std::move(items));
        changed.slots_ = slots_;
        return changed;
    }
    Table without(std::string_view key) const {
        const size_t i = index_of(key);
        if (i == npos) return *this;
        std::vector<T> items(begin(), end());
        items.erase(items.begin() + static_cast<std::ptrdiff_t>(i));
        return Table(std::move(items));
    }

    // Returns true if both share their entries, in O(1); false for equal copies made separately.
    bool same(const Table& other) const {
        return items_ == other.items_ || (empty() && other.empty());
    }

private:
    using Slots = std::vector<uint32_t>;  // open addressing; 0 is free, else index + 1

    static size_t probe(const std::vector<T>& items, const Slots& slots, std::string_view key) {
        const size_t mask = slots.size() - 1;
        size_t slot = std::hash<std::string_view>()(key) & mask;
        while (slots[slot] != 0 && table_key(items[slots[slot] - 1]) != key)
            slot = (slot + 1) & mask;
        return slot;
    }
    static std::shared_ptr<const Slots> index(const std::vector<T>& items) {
        Slots slots(std::bit_ceil(items.size() * 2 + 1), 0);
        for (size_t i = 0; i < items.size(); ++i) {
            uint32_t& slot = slots[probe(items, slots, table_key(items[i]))];
            if (slot == 0) slot = static_cast<uint32_t>(i + 1);
        }
        return std::make_shared<const Slots>(std::move(slots));
    }

    std::shared_ptr<const std::vector<T>> items_;
    std::shared_ptr<const Slots> slots_;
};

template <class T>
std::vector<std::string> keys_of(const Table<T>& table) {
    std::vector<std::string> keys;
    for (const T& entry : table)
        keys.emplace_back(table_key(entry));
    return keys;
}

}  // namespace wrinkle

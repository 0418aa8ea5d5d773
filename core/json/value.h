// An immutable JSON value with its location in the source text.
//
// A Value is a handle (shared tree, index), cheap to copy. All values of one text share one flat
// tree in source order and the text itself. A number retains its spelling in the source. A built
// value has no location, and its strings have U+FFFD for bytes that are not UTF-8. Objects preserve
// the order of members; of a duplicate key (reported by parse) the first is used. A default Value
// is null.
//
// Lines and columns count from 1; a column is a UTF-8 character, a tab is one column.
#pragma once

#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/diagnostics.h"

namespace wrinkle::json {

enum class Kind : uint8_t { null, boolean, number, string, array, object };

// Returns "a number", "an object", ... for messages.
const char* kind_name(Kind kind);

// Returns "/key", the key as one step of a JSON pointer.
std::string pointer_step(std::string_view key);

struct Tree;
struct Children;

class Value {
public:
    Value() = default;
    Value(std::shared_ptr<const Tree> tree, uint32_t index)
        : tree_(std::move(tree)), index_(index) {}

    static Value boolean(bool value);
    static Value number(double value);  // shortest spelling; asserts that it is finite
    static Value single(float value);   // shortest spelling of that float
    static Value string(std::string_view text);
    static Value array(std::span<const Value> items);
    static Value object(std::span<const std::pair<std::string, Value>> members);

    Kind kind() const;
    bool is(Kind wanted) const { return kind() == wanted; }

    // Precondition (asserted): the value is of that kind.
    bool as_boolean() const;
    double as_number() const;
    std::string_view spelling() const;   // text of a number, as in the source
    std::string_view as_string() const;  // decoded; valid as long as any value of the tree

    size_t size() const;                     // children of an array or object, else 0
    Children children() const;               // range of Member; empty if not an array or object
    Value find(std::string_view key) const;  // value of a member, linear; null if absent
    bool has(std::string_view key) const;
    Value at(size_t item) const;  // item of an array; linear; asserts item < size()

    // Location in the source text, for parsed values.
    bool has_location() const;
    uint32_t offset() const;        // offset of the first byte; 0 without a location
    Location location() const;      // line 0 without a location
    Location key_location() const;  // location of the key of an object's member, else location()
    std::string pointer() const;    // JSON pointer from the root of its text
    bool cut_off() const;  // array or object ended by a syntax error: more may have followed

    // Returns the complete text that the value was parsed from; "" if it was built.
    std::string_view source() const;

    // The tree that contains the value, null for a default Value, and the value's entry in it.
    const std::shared_ptr<const Tree>& tree() const { return tree_; }
    uint32_t index() const { return index_; }
    bool same(const Value& other) const;                 // same entry of one tree; O(1)
    friend bool operator==(const Value&, const Value&);  // equal values; numbers by value

private:
    friend class ChildIterator;

    std::shared_ptr<const Tree> tree_;
    uint32_t index_ = 0;
};

struct Member {
    std::string_view key;  // "" in an array
    Value value;
};

// Steps through the children of a value in their order.
class ChildIterator {
public:
    explicit ChildIterator(const Value& parent);
    const Member& operator*() const { return member_; }
    ChildIterator& operator++();
    bool operator==(std::default_sentinel_t) const { return left_ == 0; }

private:
    void enter(uint32_t entry);

    Member member_;
    size_t left_;  // children from this one on
};

struct Children {
    Value parent;

    ChildIterator begin() const { return ChildIterator(parent); }
    std::default_sentinel_t end() const { return {}; }
};

inline Children Value::children() const {
    return {*this};
}

}  // namespace wrinkle::json

// The flat tree behind all values of one text; for core/json alone.
//
// Entries stand in source order: a container, then its children; in an object every child is two
// entries, key then value. `next` jumps over an entry's whole sub-tree, so no walk recurses.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "json/value.h"

namespace wrinkle::json {

struct Entry {
    uint32_t offset = 0;  // of its first byte in the source
    uint32_t text = 0;    // of a string or number, in the source or the pool
    uint32_t length = 0;  // of the text; of a container the number of children
    uint32_t next = 0;
    uint32_t parent = 0;  // the root's is itself
    Kind kind = Kind::null;
    bool truth = false;
    bool pooled = false;     // text stands in the pool: built, or had escapes
    bool cut_off = false;    // a container without its end
    bool duplicate = false;  // key and value both; not a child
};

struct Tree {
    std::string file;
    std::string source;
    std::string pool;
    std::vector<uint32_t> lines;   // offset of each line's first character; empty when built
    std::vector<uint32_t> blocks;  // UTF-8 characters before each block of the source
    std::vector<Entry> entries;

    bool was_read() const { return !lines.empty(); }
    std::string_view text(const Entry& entry) const {
        return {(entry.pooled ? pool : source).data() + entry.text, entry.length};
    }
    void index_source();  // fills lines and blocks
    Location location(uint32_t offset) const;

private:
    uint32_t characters_before(uint32_t offset) const;
};

inline bool is_container(Kind kind) {
    return kind == Kind::array || kind == Kind::object;
}

// For the writer, which walks the entries themselves. A null Value has no tree.
const Tree* tree_of(const Value& value);
uint32_t index_of(const Value& value);

}  // namespace wrinkle::json

// The flat tree behind all values of one text; for core/json alone.
//
// Entries stand in source order: a container, then its children; in an object every child is two
// entries, key then value. `after` jumps over an entry's whole sub-tree, so no walk recurses. Large
// texts have millions of entries: the time that one takes is that of its bytes.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "json/value.h"

namespace wrinkle::json {

struct Entry {
    uint32_t offset = 0;  // of its first byte in the source
    uint32_t length = 0;  // of a string's or number's text; of a container the number of children
    uint32_t place = 0;   // of a container the entry behind its last; of a pooled text in the pool
    uint32_t parent = 0;  // the root's is itself
    Kind kind = Kind::null;
    bool truth : 1 = false;
    bool pooled : 1 = false;     // text stands in the pool: built, or had escapes
    bool cut_off : 1 = false;    // a container without its end
    bool duplicate : 1 = false;  // key and value both; not a child
};
static_assert(sizeof(Entry) == 20);

inline bool is_container(Kind kind) {
    return kind == Kind::array || kind == Kind::object;
}

// Where the lines of a text begin: found when somebody asks. Nobody does of a text that is well.
class Lines {
public:
    // Of a byte of the text, which is the same at every call; without the file.
    Location location(std::string_view text, uint32_t offset);

private:
    void find_all(std::string_view text);
    uint32_t characters_before(std::string_view text, uint32_t offset) const;

    std::once_flag found_;          // values are read by several threads
    std::vector<uint32_t> begins_;  // offset of each line's first character
    std::vector<uint32_t> blocks_;  // UTF-8 characters before each block of the text
};

struct Tree {
    std::string file;
    std::string source;
    std::string pool;
    std::unique_ptr<Lines> lines;  // none when built
    std::vector<Entry> entries;

    bool was_read() const { return lines != nullptr; }
    // Of a string, decoded, or of a number.
    std::string_view text(const Entry& entry) const {
        if (entry.pooled) return {pool.data() + entry.place, entry.length};
        return {source.data() + entry.offset + (entry.kind == Kind::string), entry.length};
    }
    uint32_t after(uint32_t i) const {
        return is_container(entries[i].kind) ? entries[i].place : i + 1;
    }
    Location location(uint32_t offset) const;
};

// Where a text begins: behind its byte order mark.
inline uint32_t begin_of(std::string_view source) {
    return source.starts_with("\xEF\xBB\xBF") ? 3 : 0;
}

// For the writer, which walks the entries themselves. A null Value has no tree.
const Tree* tree_of(const Value& value);
uint32_t index_of(const Value& value);

}  // namespace wrinkle::json

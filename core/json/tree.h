// The flat tree shared by all values of one text; internal to core/json.
//
// Entries are stored in source order: a container, then its children; in an object each child has
// two entries, key then value. after() skips an entry's sub-tree, so that no traversal recurses.
// Large texts have millions of entries, and traversal is limited by memory bandwidth: an entry has
// 20 bytes.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "json/value.h"

namespace wrinkle::json {

struct Entry {
    uint32_t offset = 0;  // offset of its first byte in the source
    uint32_t length = 0;  // string, number: of the text; container: children; boolean: 1 for true
    uint32_t end = 0;     // container: index after its last entry; pooled text: its end in the pool
    uint32_t parent = 0;  // parent entry; the root's is the root
    Kind kind = Kind::null;
    bool pooled = false;     // the decoded text is in the pool: the source has escapes
    bool cut_off = false;    // a container without its end
    bool duplicate = false;  // set on key and value; not counted as a child
};
static_assert(sizeof(Entry) == 20);

inline bool is_container(Kind kind) {
    return kind == Kind::array || kind == Kind::object;
}

struct Tree {
    std::string file;
    std::string source;
    std::string pool;
    bool is_parsed = false;  // false: a built value, without locations
    std::vector<Entry> entries;

    // Returns the spelling of a number, or a decoded string. Precondition: it is one of these.
    std::string_view text(const Entry& entry) const {
        if (entry.pooled) return {pool.data() + entry.end - entry.length, entry.length};
        return {source.data() + entry.offset + (entry.kind == Kind::string), entry.length};
    }
    // Returns the index of the first entry after entry i and its descendants.
    uint32_t after(uint32_t i) const {
        return is_container(entries[i].kind) ? entries[i].end : i + 1;
    }
    // Returns the location of a byte of the source. O(1) after the first call, which is linear in
    // the source. Thread-safe.
    Location location(uint32_t offset) const;

private:
    struct Mark {
        uint32_t line = 1, column = 1;
    };
    static constexpr uint32_t bytes_between_marks = 4096;
    Mark advanced(Mark mark, uint32_t begin, uint32_t end) const;

    struct Marks {
        std::once_flag made;
        std::vector<Mark> list;  // of every bytes_between_marks-th byte

        Marks() = default;
        Marks(const Marks&) {}  // a copy of the tree makes them again
    };
    mutable Marks marks_;
};

// Returns the offset of the text after a byte order mark.
inline uint32_t begin_of(std::string_view source) {
    return source.starts_with("\xEF\xBB\xBF") ? 3 : 0;
}

}  // namespace wrinkle::json

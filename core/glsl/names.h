// Identifiers for generated text: legal in every target, unique, and the same tomorrow.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glsl/line.h"
#include "ir/module.h"

namespace wrinkle {

// What somebody would like to be called: two words joined by an underscore, or the second alone.
struct WantedName {
    std::string_view first, second;
    size_t size() const { return first.size() + !first.empty() + second.size(); }
};

// A name by its place among all texts of its set; it holds while the set grows. Length 0: none.
struct Name {
    uint32_t begin = 0, length = 0;
};

// The names of one scope. `outer`, where given, must outlive it; its names are taken here too.
class NameSet {
public:
    explicit NameSet(const NameSet* outer = &reserved_words()) : outer_(outer) {}
    // Keywords, words kept for later versions, and the built-in functions that a text may call.
    static const NameSet& reserved_words();
    static NameSet with_reserved_words();

    // What is wanted, made an identifier; "_2", "_3", ... is added where it is taken.
    Name add(const WantedName& wanted);
    std::string unique(std::string_view wanted) { return std::string(text(add({{}, wanted}))); }
    std::string_view text(Name name) const {
        return text_behind(name.begin).substr(0, name.length);
    }
    void make_room(size_t more);  // for so many names at once

private:
    struct Entry {
        Name name;
        uint32_t hash = 0;
        uint32_t next = 2;  // the number to try behind it
    };
    std::string_view text_behind(size_t begin) const { return pool_.view().substr(begin); }
    size_t slot_of(std::string_view name, uint32_t hash) const;
    bool has(std::string_view name, uint32_t hash) const;
    bool taken_outside(std::string_view name, uint32_t hash) const;
    // The last text of the pool becomes this free slot's.
    Name fill(size_t slot, size_t begin, uint32_t hash);
    Name numbered(Entry& taken);

    const NameSet* outer_;
    Line pool_;  // all texts, then what is being made
    std::vector<Entry> entries_;
    // Open addressing, at most half full: an entry's number from 1 on, 0 where none is. What is
    // asked for in any order is so a quarter of the memory that the entries take.
    std::vector<uint32_t> slots_;
};

// The name of a surface input's change: "dpdx", "duv0_dy"; of the input itself its own.
std::string_view change_name(uint32_t input_extra);

// What a value is, in one word, for temporaries that are no node's output: "texel", "sum", ...
std::string_view word_for(const Module& module, Id id);

// The name as it may stand in a line comment: one line, that reads as it is written. No control
// characters, Unicode's ends of lines and turns of direction included, no backslash, not too long.
std::string comment_text(std::string_view text);
void append_comment_text(Line& line, std::string_view text);

}  // namespace wrinkle

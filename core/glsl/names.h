// Identifiers for generated text: legal in every target, unique, and the same tomorrow.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glsl/line.h"
#include "ir/module.h"

namespace wrinkle {

// Keywords, words kept for later versions, and the built-in functions that a text may call.
bool is_reserved(std::string_view word);

// What somebody would like to be called: two words joined by an underscore, or the second alone.
struct WantedName {
    std::string_view first, second;
    size_t size() const { return first.size() + !first.empty() + second.size(); }
};

// A name by its place among all texts of a table; it holds while the table grows. Length 0: none.
struct Name {
    uint32_t begin = 0, length = 0;
};

// Texts that are there, each once. Open addressing, at most half full; a text is hashed once.
class NameTable {
public:
    struct Entry {
        Name name;
        uint32_t hash = 0;
        uint32_t next = 2;  // the number to try behind it
    };
    std::string_view text(Name name) const {
        return std::string_view(pool).substr(name.begin, name.length);
    }
    bool has(std::string_view name, uint32_t hash) const;
    // Of a text that is there or of the free place for it; until the next make_room().
    Entry& at(std::string_view name, uint32_t hash);
    // Before at() is filled: so that `more` can be.
    void make_room(size_t more);
    // The text behind `begin` in the pool becomes this free entry's.
    Name fill(Entry& entry, uint32_t begin, uint32_t hash);

    std::string pool;  // all texts, then what is being made

private:
    size_t place_of(std::string_view name, uint32_t hash) const;

    std::vector<Entry> entries_;
    size_t count_ = 0;
};

// The words of is_reserved().
const NameTable& reserved_words();

// The names of one scope. `outer`, where given, must outlive it; its names are taken here too.
class NameSet {
public:
    explicit NameSet(const NameSet* outer = nullptr) : outer_(outer) {}

    // What is wanted, made an identifier; "_2", "_3", ... is added where it is taken or reserved.
    Name add(const WantedName& wanted);
    std::string unique(std::string_view wanted) { return std::string(text(add({{}, wanted}))); }
    std::string_view text(Name name) const { return table_.text(name); }

private:
    bool taken_outside(std::string_view name, uint32_t hash) const;
    Name numbered(NameTable::Entry& taken);

    const NameSet* outer_;
    NameTable table_;
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

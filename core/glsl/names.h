// Identifiers for generated text: legal in every target, unique, and the same tomorrow.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

// Keywords, words kept for later versions, and the built-in functions that a text may call.
bool is_reserved(std::string_view word);

// The names of one scope. `outer`, where given, must outlive it; its names are taken here too.
class NameSet {
public:
    explicit NameSet(const NameSet* outer = nullptr) : outer_(outer) {}

    // `wanted` made an identifier; "_2", "_3", ... is added where it is taken or reserved.
    std::string unique(std::string_view wanted);

private:
    struct Entry {
        uint32_t begin = 0, length = 0;  // in pool_; length 0 is free
        uint32_t next = 2;               // the number to try behind it
    };
    // Of a name that is there or of the free place for it.
    size_t place_of(std::string_view name) const;
    bool taken(std::string_view name) const;
    Entry& entry_of(std::string_view name);
    void grow();

    const NameSet* outer_;
    std::string pool_;            // all names
    std::vector<Entry> entries_;  // open addressing, at most half full
    size_t count_ = 0;
};

// The name of a surface input's change: "dpdx", "duv0_dy"; of the input itself its own.
std::string change_name(uint32_t input_extra);

// What a value is, in one word, for temporaries that are no node's output: "texel", "sum", ...
std::string_view word_for(const Module& module, Id id);

// The name as it may stand in a line comment: one line, that reads as it is written. No control
// characters, Unicode's ends of lines and turns of direction included, no backslash, not too long.
std::string comment_text(std::string_view text);
void append_comment_text(std::string& line, std::string_view text);

}  // namespace wrinkle

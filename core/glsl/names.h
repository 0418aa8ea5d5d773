// Identifiers for generated text: legal in every target, unique, and the same tomorrow.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

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
    bool taken(const std::string& name) const;

    const NameSet* outer_;
    std::unordered_set<std::string> names_;
    std::unordered_map<std::string, uint32_t> next_;
};

// The fixed name of a value that belongs to the surface point and not to one node: "normal",
// "dpdx", "duv0_dx", "uv0_tangent", ...; "" where it has none.
std::string surface_name(const Module& module, Id id);

// What a value is, in one word, for temporaries that are no node's output: "texel", "sum", ...
std::string_view word_for(const Module& module, Id id);

// The name as it may stand in a line comment: no control characters, no backslash, not too long.
std::string comment_text(std::string_view text);

}  // namespace wrinkle

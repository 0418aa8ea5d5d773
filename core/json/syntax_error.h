// Syntax errors of a JSON text, from the state of the parser at the error: the last token that it
// accepted and the container that is open there. Internal to core/json.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "json/value.h"

namespace wrinkle::json {

struct SyntaxError {
    uint32_t offset = 0;  // where the text needs to be corrected
    std::string message;
    std::string expected;
};

// State of the parser at an error.
struct ParserState {
    std::string_view source;
    uint32_t cursor = 0;          // end of the last accepted token
    uint32_t consumed = 0;        // one past the byte at which the lexer stopped
    Kind container = Kind::null;  // the open one; null: none, the text itself
    uint32_t added = 0;           // its direct children: values, and in an object also keys
    bool out_of_range = false;    // the error is a number that no double holds
};

SyntaxError explain(const ParserState& state);

inline bool is_space(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

// Returns the offset of the first byte from `offset` on that is not white space.
inline uint32_t skip_space(std::string_view source, uint32_t offset) {
    return static_cast<uint32_t>(std::find_if_not(source.begin() + offset, source.end(), is_space) -
                                 source.begin());
}

}  // namespace wrinkle::json

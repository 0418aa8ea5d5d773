// Converts syntax errors of the JSON library to messages of this project, at the location where the
// text needs to be corrected. Internal to core/json.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace wrinkle::json {

struct SyntaxError {
    uint32_t offset = 0;
    std::string message;
    std::string expected;
};

// `what` is the library's message, `cursor` the end of the last valid token, `consumed` the number
// of bytes that the library has read (one past the end of a number).
SyntaxError explain(std::string_view what, std::string_view source, uint32_t cursor,
                    uint32_t consumed);

inline bool is_space(char c) {
    return c <= ' ' && (c == ' ' || c == '\n' || c == '\t' || c == '\r');
}

// Returns the offset after skipping white space from `cursor` on, and each ',' and ':' at an offset
// below `limit` - 1 (`limit` 0: none).
uint32_t token_start(std::string_view source, uint32_t cursor, uint32_t limit);

}  // namespace wrinkle::json

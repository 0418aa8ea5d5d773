// What the JSON library says about a syntax error, put in the words of this project and at the
// place where the reader of the text would mend it; for core/json alone.
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

// `what` is the library's text, `cursor` the end of the last token that was understood, `consumed`
// how many bytes the library has taken (one ahead of a number).
SyntaxError explain(std::string_view what, std::string_view source, uint32_t cursor,
                    uint32_t consumed);

inline bool is_space(char c) {
    return c <= ' ' && (c == ' ' || c == '\n' || c == '\t' || c == '\r');
}

// From `cursor` over white space, and over ',' and ':' that stand before `limit`.
uint32_t token_start(std::string_view source, uint32_t cursor, uint32_t limit);

}  // namespace wrinkle::json

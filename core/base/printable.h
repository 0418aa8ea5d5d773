// UTF-8 decoding and escaping of characters that are unsafe to print.
//
// Terminals and editors execute control characters: ESC moves the cursor, a line break can forge a
// message line, and bidirectional controls reorder the text that follows. So names and texts that
// come from files are printed escaped.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace wrinkle {

struct Character {
    uint32_t code = 0;  // Unicode code point; the byte itself if it does not start a character
    uint8_t bytes = 1;
    bool valid = true;  // well-formed UTF-8: no surrogate, no overlong form
};
// Returns the first character. Precondition: `text` is not empty.
Character first_character(std::string_view text);

inline bool is_printable_ascii(char c) {
    return c >= ' ' && c <= '~';
}

// Returns false for control characters (C0, DEL, C1), line and paragraph separators, bidirectional
// controls, and bytes that are not UTF-8.
bool is_printable(const Character& character);

// Returns `text` on one line with each non-printable character escaped: \n, \r, \t, \x1b, \u202e; a
// byte that is not UTF-8 as \xff. O(n).
std::string printable(std::string_view text);

}  // namespace wrinkle

// Characters of UTF-8, and which of them may be shown as they are.
//
// Terminals and editors obey control characters: ESC moves the cursor, a line break begins a line
// that looks like a message of its own, and the controls of bidirectional text change the order of
// what follows. So names and texts that come from files are printed escaped.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace wrinkle {

struct Character {
    uint32_t code = 0;  // of Unicode; the byte itself where it begins no character
    uint8_t bytes = 1;
    bool valid = true;  // well-formed UTF-8: no surrogate, no overlong form
};
// The first of a text that is not empty.
Character first_character(std::string_view text);

// False of control characters (C0, DEL, C1), line and paragraph separators, controls of
// bidirectional text, and bytes that are not UTF-8.
bool is_printable(const Character& character);

// The same text on one line, each character that is not printable escaped: \n, \r, \t, \x1b,
// \u202e; a byte that is not UTF-8 as \xff. O(n).
std::string printable(std::string_view text);

}  // namespace wrinkle

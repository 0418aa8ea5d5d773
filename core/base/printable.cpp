#include "base/printable.h"

#include <algorithm>
#include <bit>
#include <cstdio>

namespace wrinkle {
namespace {

bool is_between(uint32_t code, uint32_t first, uint32_t last) {
    return first <= code && code <= last;
}

void append_escaped(std::string& text, const Character& character) {
    if (character.code == '\n') {
        text += "\\n";
    } else if (character.code == '\r') {
        text += "\\r";
    } else if (character.code == '\t') {
        text += "\\t";
    } else {
        char escape[16];
        const bool byte = !character.valid || character.code < 0x80;
        std::snprintf(escape, sizeof escape, byte ? "\\x%02x" : "\\u%04x", character.code);
        text += escape;
    }
}

}  // namespace

Character first_character(std::string_view text) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    const Character broken{lead, 1, false};
    const int ones = std::countl_one(lead);
    const auto length = static_cast<uint8_t>(std::max(ones, 1));
    if (ones == 1 || ones > 4 || length > text.size()) return broken;
    uint32_t code = length == 1 ? lead : lead & (0x7FU >> length);
    for (size_t k = 1; k < length; ++k) {
        if ((byte(k) & 0xC0) != 0x80) return broken;
        code = code << 6 | (byte(k) & 0x3FU);
    }
    constexpr uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};  // by length; else it is overlong
    if (code < least[length] || code > 0x10FFFF || is_between(code, 0xD800, 0xDFFF)) return broken;
    return {code, length, true};
}

bool is_printable(const Character& character) {
    const uint32_t code = character.code;
    const bool control = code < 0x20 || is_between(code, 0x7F, 0x9F);
    const bool separator = code == 0x2028 || code == 0x2029;
    const bool bidirectional = code == 0x061C || is_between(code, 0x200E, 0x200F) ||
                               is_between(code, 0x202A, 0x202E) || is_between(code, 0x2066, 0x2069);
    return character.valid && !control && !separator && !bidirectional;
}

std::string printable(std::string_view text) {
    if (std::ranges::all_of(text, is_printable_ascii)) return std::string(text);
    std::string line;
    while (!text.empty()) {
        const Character character = first_character(text);
        if (is_printable(character))
            line += text.substr(0, character.bytes);
        else
            append_escaped(line, character);
        text.remove_prefix(character.bytes);
    }
    return line;
}

}  // namespace wrinkle

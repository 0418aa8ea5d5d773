#include "report/xml.h"

#include <cstdint>

#include "base/printable.h"

namespace wrinkle::report {
namespace {

constexpr char escape = 0x1B;

bool is_within(char c, char first, char last) {
    return c >= first && c <= last;
}

// Returns the bytes of the escape sequence that the text begins with; 0 if there is none. A control
// sequence is ESC [, parameters, intermediates and a final byte; a string of the terminal is ESC ],
// its text and BEL or ESC \; others are ESC and a byte from '@' to '_'.
size_t sequence_length(std::string_view text) {
    if (text.size() < 2 || text[0] != escape || !is_within(text[1], '@', '_')) return 0;
    size_t i = 2;
    if (text[1] == '[') {
        while (i < text.size() && is_within(text[i], '0', '?'))
            ++i;
        while (i < text.size() && is_within(text[i], ' ', '/'))
            ++i;
        return i < text.size() && is_within(text[i], '@', '~') ? i + 1 : 2;
    }
    if (text[1] != ']') return 2;
    const size_t end = text.find_first_of("\a\x1B", i);
    if (end == text.npos) return 2;
    return text.substr(end).starts_with("\x1B\\") ? end + 2 : end + (text[end] == '\a' ? 1 : 0);
}

bool is_allowed(const Character& character) {
    const uint32_t code = character.code;
    const bool control = code < 0x20 && code != '\t' && code != '\n' && code != '\r';
    return character.valid && !control && code != 0xFFFE && code != 0xFFFF;
}

std::string_view reference(char c, bool in_attribute) {
    switch (c) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '\r':  // a reader takes a plain one for a line end
            return "&#13;";
        case '"':
            return in_attribute ? "&quot;" : "";
        case '\'':
            return in_attribute ? "&apos;" : "";
        case '\t':
            return in_attribute ? "&#9;" : "";
        case '\n':
            return in_attribute ? "&#10;" : "";
        default:
            return "";
    }
}

std::string with_references(std::string_view text, bool in_attribute) {
    std::string result;
    for (const char c : xml_characters(text)) {
        const std::string_view written = reference(c, in_attribute);
        if (written.empty())
            result += c;
        else
            result += written;
    }
    return result;
}

}  // namespace

std::string xml_characters(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        if (const size_t length = sequence_length(text)) {
            text.remove_prefix(length);
            continue;
        }
        const Character character = first_character(text);
        if (is_allowed(character))
            result += text.substr(0, character.bytes);
        else
            result += "\xEF\xBF\xBD";
        text.remove_prefix(character.bytes);
    }
    return result;
}

std::string xml_attribute(std::string_view text) {
    return with_references(text, true);
}

std::string xml_text(std::string_view text) {
    return with_references(text, false);
}

}  // namespace wrinkle::report

#include "json/syntax_error.h"

#include <algorithm>
#include <array>

#include "base/case.h"
#include "base/text.h"

namespace wrinkle::json {
namespace {

// Token that the grammar allows after the accepted ones.
enum class Next : uint8_t { value, key, colon, comma_or_end, end_of_file };

Next next_in(const ParserState& state) {
    if (state.container == Kind::null) return state.added == 0 ? Next::value : Next::end_of_file;
    if (state.container == Kind::object && state.added % 2 == 1) return Next::colon;
    if (state.added > 0) return Next::comma_or_end;
    return state.container == Kind::object ? Next::key : Next::value;
}

std::string wanted(Next next, Kind container) {
    if (next == Next::comma_or_end)
        return container == Kind::object ? "expected ',' or '}'" : "expected ',' or ']'";
    static constexpr std::array texts = {"expected a value", "expected a key in double quotes",
                                         "expected ':'", "", "expected the end of the file"};
    return texts[static_cast<size_t>(next)];
}

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '+' || c == '-' || c == '.';
}

std::string word_at(std::string_view source, uint32_t begin) {
    constexpr size_t longest = 40;  // maximum length in a message
    size_t end = begin;
    while (end < source.size() && is_word(source[end]) && end - begin <= longest)
        ++end;
    if (end - begin <= longest) return std::string(source.substr(begin, end - begin));
    return std::string(source.substr(begin, longest)) + "...";
}

std::string character_at(std::string_view source, uint32_t at) {
    static constexpr char hex[] = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(source[at]);
    if (byte > 0x20 && byte < 0x7F) return std::string("character '") + source[at] + "'";
    return std::string("byte 0x") + hex[byte >> 4] + hex[byte & 15];
}

bool is_number(std::string_view word) {
    return !word.empty() && (word[0] == '-' || (word[0] >= '0' && word[0] <= '9'));
}

bool is_not_finite(std::string_view word) {
    const size_t digits = std::min(word.find_first_not_of("+-"), word.size());
    const std::string lower = lower_case(word.substr(digits));
    return lower == "nan" || lower == "inf" || lower == "infinity";
}

std::string found(std::string_view source, uint32_t start, std::string_view word) {
    constexpr std::string_view punctuation = "{}[]:,";
    if (start == source.size()) return "end of the file";
    if (source[start] == '"') return "string";
    if (is_number(word)) return "number " + std::string(word);
    if (!word.empty()) return "'" + std::string(word) + "'";
    if (punctuation.find(source[start]) != punctuation.npos)
        return std::string("'") + source[start] + "'";
    return character_at(source, start);
}

SyntaxError bad_string(std::string_view source, uint32_t start, uint32_t consumed) {
    const uint32_t last = consumed - 1;
    if (!is_utf8(source.substr(start, consumed - start)))
        return {last, "the string is not valid UTF-8 at " + character_at(source, last),
                "save the file as UTF-8"};
    if (source[last] == '\n' || source[last] == '\r')
        return {last, "the string has no closing quote on its line",
                "expected '\"', or \\n for a line break"};
    if (static_cast<unsigned char>(source[last]) < 0x20) {
        const std::string byte = character_at(source, last);  // "byte 0x09"
        return {last, "the string contains the unescaped " + byte,
                "write \\u00" + byte.substr(byte.size() - 2)};
    }
    if (consumed == source.size())
        return {start, "the string has no closing quote", "expected '\"'"};
    return {
        last, "the string has an invalid escape",
        "expected \\\", \\\\, \\/, \\b, \\f, \\n, \\r, \\t, or \\u and four hexadecimal digits, "
        "surrogates in pairs"};
}

SyntaxError bad_number(const ParserState& state, uint32_t start, const std::string& word) {
    if (state.out_of_range)
        return {start, "the number " + word + " is out of range", "expected a finite number"};
    const size_t accepted = state.consumed == state.source.size()
                                ? word.size()
                                : std::min<size_t>(word.size(), state.consumed - start - 1);
    return {start, "'" + word + "' is not a number",
            std::string("expected digit after '") + word[accepted - 1] + "'"};
}

}  // namespace

SyntaxError explain(const ParserState& state) {
    const std::string_view source = state.source;
    uint32_t start = skip_space(source, state.cursor);
    Next next = next_in(state);
    const char separator = start < source.size() ? source[start] : '\0';
    const bool comma = next == Next::comma_or_end && separator == ',';
    if (comma || (next == Next::colon && separator == ':')) {
        start = skip_space(source, start + 1);
        next = comma && state.container == Kind::object ? Next::key : Next::value;
    }
    const std::string word = word_at(source, start);
    const char first = start < source.size() ? source[start] : '\0';
    if (is_not_finite(word))
        return {start, word + " is not a number in JSON", "expected a finite number"};
    if (first == '/') return {start, "JSON has no comments", "remove it"};
    if (first == '\'') return {start, "unexpected character '", "strings need double quotes"};
    if (first == '"' && (next == Next::value || next == Next::key))
        return bad_string(source, start, state.consumed);
    if (next == Next::value && is_number(word)) return bad_number(state, start, word);
    const bool after_comma = comma && (first == '}' || first == ']');
    return {start, "unexpected " + found(source, start, word),
            after_comma ? "remove the comma before it" : wanted(next, state.container)};
}

}  // namespace wrinkle::json

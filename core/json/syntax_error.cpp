#include "json/syntax_error.h"

#include <algorithm>
#include <array>
#include <utility>

namespace wrinkle::json {
namespace {

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

bool is_not_finite(std::string_view word) {
    std::string lower;
    for (const char c :
         word.substr(word.find_first_not_of("+-") == word.npos ? word.size()
                                                               : word.find_first_not_of("+-")))
        lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    return lower == "nan" || lower == "inf" || lower == "infinity";
}

constexpr const char* any_value = "expected a value";

SyntaxError bad_word(std::string_view source, uint32_t start) {
    const std::string word = word_at(source, start);
    if (is_not_finite(word))
        return {start, word + " is not a number in JSON", "expected a finite number"};
    if (!word.empty()) return {start, "unexpected '" + word + "'", any_value};
    if (source[start] == '/') return {start, "JSON has no comments", "remove it"};
    if (source[start] == '\'')
        return {start, "unexpected character '", "strings stand in double quotes"};
    return {start, "unexpected " + character_at(source, start), any_value};
}

SyntaxError bad_token(std::string_view reason, std::string_view source, uint32_t start,
                      uint32_t consumed) {
    const auto last = static_cast<uint32_t>(
        std::min<size_t>(std::max(consumed, 1u) - 1, source.empty() ? 0 : source.size() - 1));
    const std::string word = start < source.size() ? word_at(source, start) : "";
    if (reason == "invalid literal" || is_not_finite(word)) return bad_word(source, start);
    if (reason == "invalid string: missing closing quote")
        return {start, "the string has no closing quote", "expected '\"'"};
    if (reason == "invalid string: ill-formed UTF-8 byte")
        return {last, "the string is not valid UTF-8 at " + character_at(source, last),
                "save the file as UTF-8"};
    if (reason.substr(0, 14) == "invalid number")
        return {start, "'" + word + "' is not a number", std::string(reason.substr(16))};
    if (reason.substr(0, 14) == "invalid string")
        return {last, std::string(reason.substr(16)), "mend the string"};
    return {start, std::string(reason), ""};
}

std::string found(std::string_view token, std::string_view source, uint32_t start) {
    if (token == "end of input")
        return start < source.size() ? character_at(source, start) : "end of the file";
    if (token == "string literal") return "string";
    if (token == "number literal") return "number " + word_at(source, start);
    if (token == "true literal" || token == "false literal" || token == "null literal")
        return "'" + word_at(source, start) + "'";
    return std::string(token);
}

std::string wanted(std::string_view token) {
    static constexpr std::array<std::pair<std::string_view, const char*>, 5> words = {{
        {"'[', '{', or a literal", any_value},
        {"string literal", "expected a key in double quotes"},
        {"end of input", "expected the end of the file"},
        {"']'", "expected ',' or ']'"},
        {"'}'", "expected ',' or '}'"},
    }};
    for (const auto& [name, text] : words)
        if (name == token) return text;
    return "expected " + std::string(token);
}

bool after_comma(std::string_view source, uint32_t start) {
    while (start > 0 && is_space(source[start - 1]))
        --start;
    return start > 0 && source[start - 1] == ',';
}

}  // namespace

uint32_t token_start(std::string_view source, uint32_t cursor, uint32_t limit) {
    while (cursor < source.size()) {
        const char c = source[cursor];
        const bool separator = (c == ',' || c == ':') && cursor + 1 < limit;
        if (!is_space(c) && !separator) break;
        ++cursor;
    }
    return cursor;
}

SyntaxError explain(std::string_view what, std::string_view source, uint32_t cursor,
                    uint32_t consumed) {
    static constexpr std::string_view unexpected = "unexpected ";
    // Does not skip a separator that is the last consumed byte: it may be the unexpected token. At
    // the end of the input, it is skipped below.
    uint32_t start = token_start(source, cursor, consumed);
    const size_t dash = what.find(" - ");
    if (dash == what.npos)
        return {start, "the number " + word_at(source, start) + " is out of range",
                "expected a finite number"};
    const std::string_view reason = what.substr(dash + 3);
    if (const size_t read = reason.find("; last read: "); read != reason.npos)
        return bad_token(reason.substr(0, read), source, start, consumed);
    const size_t semicolon = reason.find("; expected ");
    const size_t split = std::min(semicolon, reason.size());
    const std::string_view token = reason.substr(unexpected.size(), split - unexpected.size());
    if (token == "end of input") start = token_start(source, start, ~0u);
    const std::string message = "unexpected " + found(token, source, start);
    if ((token == "'}'" || token == "']'") && after_comma(source, start))
        return {start, message, "remove the comma before it"};
    return {start, message, semicolon == reason.npos ? "" : wanted(reason.substr(semicolon + 11))};
}

}  // namespace wrinkle::json

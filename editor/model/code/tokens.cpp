#include "editor/model/code/tokens.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace wrinkle::editor {
namespace {

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c));
}
bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

bool is_type(std::string_view word) {
    constexpr std::string_view types[] = {
        "void",  "float", "int",   "uint",  "bool",  "vec2",      "vec3",
        "vec4",  "ivec2", "ivec3", "ivec4", "uvec2", "uvec3",     "uvec4",
        "bvec2", "bvec3", "mat2",  "mat3",  "mat4",  "sampler2D", "samplerCube"};
    return std::ranges::find(types, word) != std::end(types) || word.starts_with("WrinkleSurface");
}

bool is_keyword(std::string_view word) {
    constexpr std::string_view words[] = {"struct", "uniform", "return", "for",     "while", "if",
                                          "else",   "const",   "in",     "out",     "inout", "true",
                                          "false",  "break",   "layout", "location"};
    return std::ranges::find(words, word) != std::end(words);
}

// Returns the end of the number that begins at `at`: "12", "0.5", "1e-06", "3u".
size_t end_of_number(std::string_view line, size_t at) {
    size_t end = at;
    while (end < line.size()) {
        const bool exponent = end > at && (line[end - 1] == 'e' || line[end - 1] == 'E');
        const bool sign = exponent && (line[end] == '-' || line[end] == '+');
        if (!is_word(line[end]) && line[end] != '.' && !sign) break;
        ++end;
    }
    return end;
}

Piece word_at(std::string_view line, size_t at) {
    size_t end = at;
    while (end < line.size() && is_word(line[end]))
        ++end;
    const std::string_view word = line.substr(at, end - at);
    Token token = Token::text;
    if (is_keyword(word))
        token = Token::keyword;
    else if (is_type(word))
        token = Token::type;
    else if (end < line.size() && line[end] == '(')
        token = Token::function;
    return {at, end, token};
}

Piece piece_at(std::string_view line, size_t at) {
    if (line.substr(at).starts_with("//")) return {at, line.size(), Token::comment};
    if (line[at] == '#') return {at, line.size(), Token::keyword};
    const bool point = line[at] == '.' && at + 1 < line.size() && is_digit(line[at + 1]) &&
                       (at == 0 || !is_word(line[at - 1]));
    if (is_digit(line[at]) || point) return {at, end_of_number(line, at), Token::number};
    if (is_word(line[at])) return word_at(line, at);
    size_t end = at + 1;
    while (end < line.size() && !is_word(line[end]) && line[end] != '/' && line[end] != '#' &&
           line[end] != '.')
        ++end;
    return {at, end, Token::text};
}

}  // namespace

std::vector<Piece> pieces_of(std::string_view line) {
    std::vector<Piece> pieces;
    for (size_t at = 0; at < line.size(); at = pieces.back().end)
        pieces.push_back(piece_at(line, at));
    return pieces;
}

}  // namespace wrinkle::editor

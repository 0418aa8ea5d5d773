// Splits GLSL into tokens for syntax highlighting. Works line by line: generated source has no
// multi-line comments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace wrinkle::editor {

enum class Token : uint8_t { text, keyword, type, function, number, comment };

struct Piece {
    size_t begin = 0, end = 0;  // bytes in the line
    Token token = Token::text;
};

// Covers the complete line, in order, without gaps.
std::vector<Piece> pieces_of(std::string_view line);

}  // namespace wrinkle::editor

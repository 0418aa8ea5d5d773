// GLSL cut into pieces that are coloured alike. Lines are taken one by one: generated text has no
// comment that runs over several.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace wrinkle::editor {

enum class Token : uint8_t { text, keyword, type, function, number, comment };

struct Piece {
    size_t begin = 0, end = 0;  // bytes of the line
    Token token = Token::text;
};

// All of the line, in order, without gaps.
std::vector<Piece> pieces_of(std::string_view line);

}  // namespace wrinkle::editor

// Lines of text and the node that each came from.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/reflection.h"

namespace wrinkle {

struct Text {
    std::string text;
    std::vector<uint32_t> nodes;  // by line

    void line(int indent, std::string_view content, uint32_t node = no_node) {
        text.append(content.empty() ? 0 : 4 * static_cast<size_t>(indent), ' ');
        text += content;
        text += '\n';
        nodes.push_back(node);
    }
    // The pieces, one behind the other.
    void line(int indent, std::initializer_list<std::string_view> pieces, uint32_t node = no_node) {
        text.append(4 * static_cast<size_t>(indent), ' ');
        for (const std::string_view piece : pieces)
            text += piece;
        text += '\n';
        nodes.push_back(node);
    }
};

}  // namespace wrinkle

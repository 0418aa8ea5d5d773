// Lines of text and the node that each came from.
#pragma once

#include <cstdint>
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
    void append(const Text& other) {
        text += other.text;
        nodes.insert(nodes.end(), other.nodes.begin(), other.nodes.end());
    }
};

}  // namespace wrinkle

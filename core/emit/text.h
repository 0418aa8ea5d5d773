// Generated source and the node that each line came from.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "base/limits.h"
#include "emit/reflection.h"

namespace wrinkle {

struct Text {
    std::string text;
    std::vector<uint32_t> nodes;                  // by line
    uint64_t most = limit_of(Limit::text_bytes);  // bytes; if exceeded, line() throws OverLimit

    void line(int indent, std::string_view content, uint32_t node = no_node) {
        text.append(content.empty() ? 0 : 4 * static_cast<size_t>(indent), ' ');
        text += content;
        end_line(node);
    }
    // Appends the concatenated pieces as one line.
    void line(int indent, std::initializer_list<std::string_view> pieces, uint32_t node = no_node) {
        text.append(4 * static_cast<size_t>(indent), ' ');
        for (const std::string_view piece : pieces)
            text += piece;
        end_line(node);
    }

private:
    void end_line(uint32_t node) {
        text += '\n';
        nodes.push_back(node);
        if (text.size() > most)
            throw OverLimit(Limit::text_bytes, most, node == no_node ? 0 : node, "");
    }
};

}  // namespace wrinkle

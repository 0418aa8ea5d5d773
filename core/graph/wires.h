// Which node every input of every node reads, looked up by name once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/document.h"

namespace wrinkle {

class Wires {
public:
    static constexpr uint32_t none = ~0u;

    explicit Wires(const Document& document);

    // Nodes by input; `none` where an input reads no node, or one that there is not.
    std::span<const uint32_t> of(size_t node) const {
        return std::span(read_).subspan(first_[node], first_[node + 1] - first_[node]);
    }

private:
    std::vector<uint32_t> first_, read_;
};

}  // namespace wrinkle

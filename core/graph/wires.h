// Resolved links: the source node of every node input, looked up by name once.
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

    // Source node of each input; `none` if the input does not link to a node, or the node does not
    // exist.
    std::span<const uint32_t> of(size_t node) const {
        return std::span(read_).subspan(first_[node], first_[node + 1] - first_[node]);
    }

private:
    std::vector<uint32_t> first_, read_;
};

}  // namespace wrinkle

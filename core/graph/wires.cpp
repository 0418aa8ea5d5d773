#include "graph/wires.h"

namespace wrinkle {
namespace {

uint32_t index_of(const Document& document, const Link& link) {
    if (!link.is_node()) return Wires::none;
    const size_t index = document.nodes.index_of(link.node);
    return index == Table<NodePtr>::npos ? Wires::none : static_cast<uint32_t>(index);
}

}  // namespace

Wires::Wires(const Document& document) {
    first_.reserve(document.nodes.size() + 1);
    for (const NodePtr& node : document.nodes) {
        first_.push_back(static_cast<uint32_t>(read_.size()));
        for (const Input& input : node->inputs)
            read_.push_back(index_of(document, input.link));
    }
    first_.push_back(static_cast<uint32_t>(read_.size()));
}

}  // namespace wrinkle

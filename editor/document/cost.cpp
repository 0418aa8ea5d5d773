#include "editor/document/cost.h"

namespace wrinkle::editor {
namespace {

// "1,024 ops"
std::string counted_in_thousands(uint32_t count, const char* what) {
    std::string digits = std::to_string(count);
    for (size_t at = digits.size(); at > 3; at -= 3)
        digits.insert(at - 3, ",");
    return digits + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

Costs count_costs(const Module& module, const Document& document) {
    Costs costs;
    costs.nodes.resize(document.nodes.size());
    const std::vector<Cost> instances = cost_by_node(module);
    for (size_t i = 0; i < instances.size(); ++i) {
        costs.total += instances[i];
        const std::string_view path = module.nodes[i].path;
        const size_t node = document.nodes.index_of(path.substr(0, path.find('/')));
        if (i > 0 && node != Table<NodePtr>::npos) costs.nodes[node] += instances[i];
    }
    return costs;
}

std::string in_words(const Cost& cost) {
    const std::string ops = counted_in_thousands(cost.ops, "op");
    return cost.reads == 0 ? ops : counted_in_thousands(cost.reads, "read") + " · " + ops;
}

}  // namespace wrinkle::editor

#include "lower/reachable.h"

#include <limits>

#include "base/limits.h"
#include "graph/subgraph.h"
#include "lower/types.h"

namespace wrinkle {
namespace {

constexpr uint64_t max_count = std::numeric_limits<uint64_t>::max();

}  // namespace

std::vector<std::vector<bool>> reachable_nodes(const Project& project) {
    std::vector<std::vector<bool>> reached;
    for (const Project::File& file : project.files)
        reached.emplace_back(file.document.nodes.size(), false);
    std::vector<bool> entered(project.files.size(), false);
    std::vector<std::pair<uint32_t, size_t>> open;  // file and node
    const auto follow = [&](uint32_t file, const Link& link) {
        if (!link.is_node()) return;
        const size_t node = project.files[file].document.nodes.index_of(link.node);
        if (node == Table<NodePtr>::npos || reached[file][node]) return;
        reached[file][node] = true;
        open.emplace_back(file, node);
    };
    const auto enter = [&](uint32_t file) {
        if (entered[file]) return;
        entered[file] = true;
        for (const Output& output : project.files[file].document.outputs)
            follow(file, output.from.link);
    };
    enter(0);
    while (!open.empty()) {
        const auto [file, node] = open.back();
        open.pop_back();
        const uint32_t inner = project.files[file].subgraphs[node];
        if (inner != Project::File::none) enter(inner);
        for (const Input& input : project.files[file].document.nodes[node]->inputs)
            follow(file, input.link);
    }
    return reached;
}

Project reached_part(Project project) {
    const std::vector<std::vector<bool>> reached = reachable_nodes(project);
    std::vector<bool> used(project.files.size(), false);
    used[0] = true;
    for (size_t f = 0; f < project.files.size(); ++f) {
        Project::File& file = project.files[f];
        std::vector<NodePtr> nodes;
        std::vector<uint32_t> subgraphs;
        for (size_t n = 0; n < reached[f].size(); ++n) {
            if (!reached[f][n]) continue;
            nodes.push_back(file.document.nodes[n]);
            subgraphs.push_back(file.subgraphs[n]);
            if (subgraphs.back() != Project::File::none) used[subgraphs.back()] = true;
        }
        if (nodes.size() == reached[f].size()) continue;
        file.document.nodes = Table<NodePtr>(std::move(nodes));
        file.document.edited = true;  // wires as read lead to former indices
        file.subgraphs = std::move(subgraphs);
    }
    for (size_t f = 0; f < project.files.size(); ++f)
        if (!used[f]) {
            project.files[f].document = Document();
            project.files[f].subgraphs.clear();
        }
    return project;
}

uint64_t saturating_sum(uint64_t a, uint64_t b) {
    return a > max_count - b ? max_count : a + b;
}

uint64_t expanded_calls(const Project& project) {
    const std::vector<std::vector<bool>> reached = reachable_nodes(project);
    std::vector<uint64_t> calls(project.files.size(), 0);
    for (const uint32_t f : files_in_order(project)) {
        const std::vector<uint32_t>& subgraphs = project.files[f].subgraphs;
        for (size_t i = 0; i < subgraphs.size(); ++i) {
            const bool muted = project.files[f].document.nodes[i]->muted;
            if (subgraphs[i] == Project::File::none || !reached[f][i] || muted) continue;
            calls[f] = saturating_sum(calls[f], saturating_sum(1, calls[subgraphs[i]]));
        }
    }
    return calls[0];
}

bool may_expand(const Project& project, const std::string& doing, Diagnostics& diagnostics) {
    const uint64_t calls = expanded_calls(project), most = limit_of(Limit::graph_calls);
    if (calls <= most) return true;
    const std::string many =
        calls == max_count ? "more than " + std::to_string(max_count - 1) : std::to_string(calls);
    diagnostics.add(diagnose(project.top(), RuleId::over_limit,
                             doing + " would make " + many + " calls of sub-graphs, and makes " +
                                 std::to_string(most) + " at most",
                             "'wrinkle compile' makes a function of each sub-graph"));
    return false;
}

}  // namespace wrinkle

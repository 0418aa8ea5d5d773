#include "lower/expanded_calls.h"

#include <limits>

#include "base/limits.h"
#include "lower/reachable.h"
#include "lower/types.h"

namespace wrinkle {
namespace {

constexpr uint64_t countless = std::numeric_limits<uint64_t>::max();

uint64_t saturating_sum(uint64_t a, uint64_t b) {
    return a > countless - b ? countless : a + b;
}

}  // namespace

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
        calls == countless ? "more than " + std::to_string(countless - 1) : std::to_string(calls);
    diagnostics.add(diagnose(project.top(),
                             doing + " would make " + many + " calls of sub-graphs, and makes " +
                                 std::to_string(most) + " at most",
                             "'wrinkle compile' makes a function of each sub-graph"));
    return false;
}

}  // namespace wrinkle

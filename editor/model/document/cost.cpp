#include "editor/model/document/cost.h"

#include "cost/limits.h"
#include "cost/report.h"
#include "editor/model/words.h"
#include "ir/cost.h"
#include "ir/module.h"

namespace wrinkle::editor {
namespace {

// Returns the index of the node with which a path starts; npos for an empty or unknown path.
size_t node_at(const Document& document, std::string_view path) {
    return path.empty() ? Table<NodePtr>::npos
                        : document.nodes.index_of(path.substr(0, path.find('/')));
}

}  // namespace

Costs estimate_costs(const Module& module, const Document& document) {
    Costs costs;
    costs.document = document;
    costs.estimated = true;
    costs.nodes.resize(document.nodes.size());
    const std::vector<Cost> instances = cost_by_node(module);
    for (size_t i = 0; i < instances.size(); ++i) {
        ShaderCost cost;
        cost.alu = instances[i].ops;
        cost.reads = instances[i].reads;
        costs.total.cost += cost;
        const size_t node = node_at(document, module.nodes[i].path);
        if (node != Table<NodePtr>::npos) costs.nodes[node].cost += cost;
    }
    return costs;
}

Costs count_costs(const Module& module, const Document& document) {
    Costs costs = estimate_costs(module, document);
    if (costs.total.cost.alu > max_counted) {
        costs.why =
            "It is too large to be counted beside the work; wrinkle compile --cost counts it.";
        return costs;
    }
    std::string why;
    const auto report = measure_cost(module, Differentials::screen, why);
    if (!report) {
        costs.why = "It cannot be counted: " + why + ".";
        return costs;
    }
    costs.estimated = false;
    costs.total = {report->total, report->texture_units};
    costs.nodes.assign(document.nodes.size(), {});
    for (const NodeCost& each : report->nodes) {
        const size_t node = node_at(document, each.node);
        if (node == Table<NodePtr>::npos) continue;
        costs.nodes[node].cost += each.cost;
        costs.nodes[node].texture_units += each.texture_units;
    }
    return costs;
}

Costs count(const CostJob& job) {
    Costs costs = count_costs(*job.module, job.document);
    costs.version = job.version;
    return costs;
}

std::string in_words(const Price& price, bool estimated) {
    const std::string about = estimated ? "~" : "";
    const std::string ops = about + counted(price.cost.alu, "op");
    return price.cost.reads == 0 ? ops : about + counted(price.cost.reads, "read") + " · " + ops;
}

std::string in_full(const Price& price, const Costs& of) {
    const ShaderCost& cost = price.cost;
    if (of.estimated)
        return "About " + counted(cost.alu, "number") + " computed and " +
               counted(cost.reads, "texture read") + ", an estimate. " +
               (of.why.empty() ? "The count follows." : of.why);
    std::string text =
        counted(cost.alu, "number") + " computed, of these " + counted(cost.divisions, "division") +
        " and " + grouped(cost.transcendental) + " transcendental\n" +
        counted(cost.reads, "texture read") + " of " + counted(price.texture_units, "texture unit");
    if (&price == &of.total)
        text += " (every machine has " + std::to_string(guaranteed_texture_units) + ")";
    if (cost.queries > 0) text += ", " + grouped(cost.queries) + " asked for a size";
    if (cost.derivative_lanes > 0)
        text += "\n" + counted(cost.derivative_lanes, "number") + " of screen derivatives";
    if (cost.branches + cost.loops > 0)
        text += "\n" + grouped(cost.branches) + " branches, " + counted(cost.loops, "loop");
    return text;
}

}  // namespace wrinkle::editor

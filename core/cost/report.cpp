#include "cost/report.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <string_view>

#include "base/printable.h"
#include "base/text.h"
#include "cost/counted_shader.h"
#include "cost/limits.h"
#include "spirv/spirv.h"

namespace wrinkle {
namespace {

// Returns the numeric columns of one row of to_text().
std::string cells(const ShaderCost& cost, size_t units) {
    char text[96];
    std::snprintf(text, sizeof text, "%6u %4u %6u %7u %6zu  ", cost.alu, cost.divisions, cost.reads,
                  cost.derivative_lanes, units);
    return text;
}

std::vector<NamedCount> named(const ShaderCost& cost) {
    return {{"alu", cost.alu},
            {"transcendental", cost.transcendental},
            {"divisions", cost.divisions},
            {"texture_reads", cost.reads},
            {"texture_queries", cost.queries},
            {"derivatives", cost.derivatives},
            {"derivative_numbers", cost.derivative_lanes},
            {"branches", cost.branches},
            {"loops", cost.loops}};
}

// Return the members of a JSON object, without braces.
std::string members(const ShaderCost& cost) {
    return joined(named(cost), ", ", [](const NamedCount& each) {
        return json_quoted(each.name) + ": " + std::to_string(each.count);
    });
}

std::string members(const ShaderCost& cost, size_t units) {
    return members(cost) + ", \"texture_units\": " + std::to_string(units);
}

// Counts the samplers that each node reads, by path; one that several nodes read counts for each.
std::map<std::string_view, size_t> units_by_node(const Reflection& reflection) {
    std::map<std::string_view, size_t> units;
    for (const SamplerInfo& sampler : reflection.samplers) {
        std::set<std::string_view> nodes;
        for (const SamplerInfo::Reader& reader : sampler.readers)
            if (nodes.insert(reader.node).second) ++units[reader.node];
    }
    return units;
}

}  // namespace

std::vector<NamedCount> named_counts(const CostReport& report) {
    std::vector<NamedCount> all = named(report.total);
    all.push_back({"texture_units", report.texture_units});
    return all;
}

CostReport cost_report(const Shader& shader, const SpirvCount& count) {
    const Reflection& r = shader.reflection;
    CostReport report;
    report.total = count.total;
    report.once = count.once;
    report.texture_units = r.samplers.size();
    const auto units = units_by_node(r);
    for (uint32_t line = 0; line < count.lines.size(); ++line) {
        const ShaderCost& cost = count.lines[line];
        const uint32_t node = counted_node(line);
        if (node == no_node || node >= r.node_paths.size()) {
            report.shared += cost;
        } else if (!(cost == ShaderCost{})) {
            const auto found = units.find(r.node_paths[node]);
            report.nodes.push_back(
                {r.node_paths[node], cost, found == units.end() ? 0 : found->second});
        }
    }
    std::stable_sort(report.nodes.begin(), report.nodes.end(),
                     [](const NodeCost& a, const NodeCost& b) { return a.cost.alu > b.cost.alu; });
    return report;
}

std::optional<CostReport> measure_cost(const Module& module, Differentials differentials,
                                       std::string& why) {
    EmitOptions options;
    options.differentials = differentials;
    options.target = find_target("glsl450");
    const Shader shader = emit(module, options);
    if (!shader.problems.empty()) {
        why = shader.problems.front().message;
        return {};
    }
    const auto words =
        compile_to_spirv(counted_shader(shader), ShaderStage::fragment, Lines::keep, why);
    const auto small = words ? optimised(*words, Inlining::all, why) : std::nullopt;
    const auto count = small ? count_spirv(*small, why) : std::nullopt;
    if (count) return cost_report(shader, *count);
    why.resize(std::min(why.find('\n'), why.size()));  // the first line of a log
    return {};
}

std::string to_text(const CostReport& report) {
    std::string text = "   ALU  div  reads  derivs  units  node\n" +
                       cells(report.total, report.texture_units) + "in all, " +
                       std::to_string(report.texture_units) + " of " +
                       std::to_string(guaranteed_texture_units) + " texture units\n";
    if (!(report.once == report.total))
        text += cells(report.once, report.texture_units) + "with the body of each loop once\n";
    for (const NodeCost& each : report.nodes)
        text += cells(each.cost, each.texture_units) + printable(each.node) + "\n";
    if (!(report.shared == ShaderCost{})) text += cells(report.shared, 0) + "(the surface point)\n";
    return text;
}

std::string to_json(const CostReport& report) {
    std::string text = "{\"total\": {" + members(report.total, report.texture_units) +
                       "},\n \"loop_bodies_once\": {" + members(report.once) + "},\n \"nodes\": [";
    const char* separator = "\n  ";
    for (const NodeCost& each : report.nodes) {
        text += separator + ("{\"node\": " + json_quoted(each.node)) + ", " +
                members(each.cost, each.texture_units) + "}";
        separator = ",\n  ";
    }
    return text + "],\n \"surface_point\": {" + members(report.shared) + "}}";
}

}  // namespace wrinkle

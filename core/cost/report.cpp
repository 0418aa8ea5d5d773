#include "cost/report.h"

#include <algorithm>
#include <cstdio>

#include "ir/op.h"

namespace wrinkle {
namespace {

std::string cells(const ShaderCost& cost) {
    char text[96];
    std::snprintf(text, sizeof text, "%8u %4u %6u %7u  ", cost.alu, cost.divisions, cost.reads,
                  cost.derivative_lanes);
    return text;
}

std::string counted(size_t count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

CountedShader counted_shader(const Shader& shader) {
    const Reflection& r = shader.reflection;
    CountedShader result;
    std::string& text = result.text;
    text = "#version 450\n";
    std::string body;
    int location = 0;
    for (const MemberInfo& member : r.members) {
        text += "layout(location = " + std::to_string(location++) + ") in " +
                std::string(info(member.type).name) + " counted_" + member.name + ";\n";
        body += "    surface." + member.name + " = counted_" + member.name + ";\n";
    }
    location = 0;
    for (const FunctionInfo& function : r.functions)
        text += "layout(location = " + std::to_string(location++) + ") out " +
                std::string(info(function.type).name) + " counted_" + function.output + "_out;\n";
    result.lines_before = static_cast<uint32_t>(std::count(text.begin(), text.end(), '\n'));
    text += shader.source + "\nvoid main() {\n";
    if (!r.struct_name.empty()) text += "    " + r.struct_name + " surface;\n";
    text += body;
    for (const FunctionInfo& function : r.functions)
        text += "    counted_" + function.output + "_out = " + function.function +
                (r.struct_name.empty() ? "();\n" : "(surface);\n");
    text += "}\n";
    return result;
}

CostReport cost_report(const Shader& shader, const CountedShader& counted,
                       const SpirvCount& count) {
    const Reflection& r = shader.reflection;
    CostReport report;
    report.total = count.total;
    report.texture_units = r.samplers.size();
    std::vector<ShaderCost> nodes(r.node_paths.size());
    for (size_t line = 0; line < count.lines.size(); ++line) {
        const size_t index = line - counted.lines_before - 1;  // wraps before the text
        const uint32_t node = index < r.lines.size() ? r.lines[index] : no_node;
        (node != 0 && node < nodes.size() ? nodes[node] : report.shared) += count.lines[line];
    }
    for (uint32_t node = 0; node < nodes.size(); ++node)
        if (!(nodes[node] == ShaderCost{})) report.nodes.push_back({node, nodes[node]});
    std::stable_sort(report.nodes.begin(), report.nodes.end(),
                     [](const NodeCost& a, const NodeCost& b) { return a.cost.alu > b.cost.alu; });
    return report;
}

std::string to_text(const CostReport& report, const Reflection& reflection) {
    std::string text = " numbers  div  reads  derivs  node\n" + cells(report.total) + "in all, " +
                       std::to_string(report.texture_units) + " of " +
                       counted(guaranteed_texture_units, "texture unit", "texture units") + "\n";
    for (const NodeCost& each : report.nodes)
        text += cells(each.cost) + reflection.node_paths[each.node] + "\n";
    if (!(report.shared == ShaderCost{})) text += cells(report.shared) + "(the surface point)\n";
    return text;
}

std::string texture_unit_problem(const Reflection& reflection) {
    const size_t used = reflection.samplers.size();
    if (used <= guaranteed_texture_units) return "";
    std::string text = "it reads " + std::to_string(used) + " images, and a shader has " +
                       std::to_string(guaranteed_texture_units) + " texture units for certain: ";
    for (size_t i = 0; i < used; ++i) {
        const SamplerInfo& sampler = reflection.samplers[i];
        text += (i ? ", " : "") + sampler.written;
        if (!sampler.readers.empty()) text += " (" + sampler.readers[0].node + ")";
    }
    return text;
}

}  // namespace wrinkle

#include "lower/lower.h"

#include "lower/lowering.h"

namespace wrinkle {
namespace {

// What an output of the program holds: numbers.
Id as_number(Module& module, PortType type, Id value) {
    if (type == PortType::gradient_) return module.add(Op::gradient_vector_, {value});
    if (type == PortType::derivative_) return module.add(Op::slope_, {value});
    return value;
}

void write_outputs(Lowering& lowering, const Project& project) {
    const FlatGraph& graph = lowering.graph();
    Module& module = lowering.module();
    for (size_t i = 0; i < graph.outputs.size(); ++i) {
        const PortType type = graph.nodes[graph.outputs[i]].pass->type;
        ModuleOutput output;
        output.name = project.top().outputs[graph.output_index[i]].name;
        output.port_type = static_cast<uint32_t>(type);
        output.value = as_number(module, type, lowering.input(graph.outputs[i], 0));
        module.outputs.push_back(std::move(output));
    }
}

// In the order of the nodes, so that a long row of muted ones asks no deeper than one.
void pass_through(Lowering& lowering, uint32_t node) {
    const NodeType& type = *lowering.graph().nodes[node].type;
    for (uint32_t p = 0; p < type.ports.size(); ++p) {
        if (type.ports[p].kind != Port::Kind::output) continue;
        const uint32_t passed = passed_input(type, p);
        if (passed != NodeType::none) lowering.input(node, passed);
    }
}

}  // namespace

Lowered lower(const Project& project, const Types& types, const LowerOptions& options,
              Diagnostics& diagnostics) {
    Lowered result;
    FlatGraph graph = flatten(project, types, options, diagnostics);
    if (diagnostics.has_errors()) return result;
    infer_bases(graph);
    order_nodes(graph, project, diagnostics);
    result.module.nodes = graph.instances;
    result.places = graph.places;
    Lowering lowering(result.module, graph, project);
    for (const uint32_t node : graph.order) {
        const FlatNode& flat = graph.nodes[node];
        if (flat.is_pass())
            lowering.input(node, 0);
        else if (flat.muted)
            pass_through(lowering, node);
        else
            build_node(lowering, node);
    }
    write_outputs(lowering, project);
    report_problems(result.module, project, result.places, diagnostics);
    return result;
}

Lowered lower(const Project& project, const Registry& registry, const LowerOptions& options,
              Diagnostics& diagnostics) {
    return lower(project, Types(project, registry), options, diagnostics);
}

void report_problems(const Module& module, const Project& project,
                     const std::vector<NodePlace>& places, Diagnostics& diagnostics) {
    report_problems(module.problems, module, project, places, diagnostics);
}

void report_problems(const std::vector<Problem>& problems, const Module& module,
                     const Project& project, const std::vector<NodePlace>& places,
                     Diagnostics& diagnostics) {
    for (const Problem& problem : problems)
        diagnostics.add(diagnose(project, places[problem.node], module.nodes[problem.node].path,
                                 problem.message, problem.expected));
}

}  // namespace wrinkle

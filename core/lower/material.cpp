#include "lower/material.h"

#include <algorithm>
#include <cassert>

#include "graph/named_files.h"
#include "graph/order.h"
#include "ir/cost.h"
#include "ir/inspect.h"
#include "ir/rewrite.h"
#include "lower/check.h"
#include "lower/flat.h"
#include "lower/reachable.h"

namespace wrinkle {
namespace {

// Operations of one point with each call counted; the most steps of a program of core/cpu.
constexpr uint32_t most_operations = 4'000'000;

bool is_broken(const Input& input) {
    return input.kind == Input::Kind::broken;
}

// Returns true if every node has a type, every sub-graph was read, and every wire has a source and
// is not part of a cycle. Reading has reported the others.
bool is_connected(const Project::File& file) {
    const Document& document = file.document;
    for (size_t i = 0; i < document.nodes.size(); ++i) {
        const Node& node = *document.nodes[i];
        if (node.type.empty()) return false;
        if (node.subgraph() && file.subgraphs[i] == Project::File::none) return false;
        for (const Input& input : node.inputs)
            if (is_broken(input)) return false;
    }
    for (const Output& output : document.outputs)
        if (is_broken(output.from)) return false;
    if (document.wires()) return true;
    Diagnostics problems;
    check_links(document, problems);
    return !problems.has_errors();
}

// For programs that run without functions: reports an error and returns false if the module makes
// too many operations with each call counted by itself.
bool may_run(const Module& module, const Project& project, const std::vector<NodePlace>& places,
             const std::string& doing, Diagnostics& diagnostics) {
    if (doing.empty() || !module.has(Op::call_)) return true;
    const std::vector<Cost> costs = cost_by_node(module);
    Cost sum;
    for (const Cost& cost : costs)
        sum += cost;
    if (sum.ops <= most_operations) return true;
    const auto dearest =
        static_cast<size_t>(std::ranges::max_element(costs, {}, &Cost::ops) - costs.begin());
    diagnostics.add(
        diagnose(project, places[dearest], module.nodes[dearest].path, RuleId::over_limit,
                 doing + " would make more than " + std::to_string(most_operations) + " operations",
                 "fewer nodes in a row that read a field"));
    return false;
}

// Runs the passes after lowering. A module that exceeds the limit is an error at the node that
// exceeds it.
void expand_into(Compiled& compiled, Module lowered, const ExpandOptions& expansion,
                 const Project& project, const MaterialOptions& options, Diagnostics& diagnostics) {
    try {
        Module module = expand(std::move(lowered), expansion);
        report_problems(module.problems, module, project, compiled.places, diagnostics);
        if (diagnostics.has_errors()) return;
        if (!may_run(module, project, compiled.places, options.runs_calls, diagnostics)) return;
        if (options.given_differentials) module = explicit_lod(std::move(module));
        assert(verify(module).empty());
        compiled.module = std::move(module);
        compiled.ok = true;
    } catch (const OverLimit& over) {
        diagnostics.add(over_limit(over, project, compiled.places));
        compiled.over_limit = true;
    }
}

}  // namespace

Compiled compile_material(const Project& project, const Registry& registry,
                          const MaterialOptions& options, Diagnostics& diagnostics) {
    Compiled compiled;
    if (diagnostics.has_errors()) return compiled;
    for (const Project::File& file : project.files)
        if (!is_connected(file)) return compiled;
    const Types types(project, registry);
    NamedFiles files(project);
    check(project, registry, types, diagnostics, {options.reachable_only, &files});
    if (diagnostics.has_errors()) return compiled;
    if (!options.runs_calls.empty() && !may_expand(project, options.runs_calls, diagnostics))
        return compiled;
    const ExpandOptions expansion{
        options.vertex_tangents, project.top().back_face_rule(), options.covariances,
        options.uniform_parameters ? Parameters::kept : Parameters::baked};
    LowerOptions lowering = options.lower;
    lowering.files = &files;
    Lowered lowered = lower(project, types, lowering, diagnostics);
    compiled.over_limit = lowered.over_limit;
    if (diagnostics.has_errors()) return compiled;
    assert(verify(lowered.module).empty());
    compiled.places = std::move(lowered.places);
    expand_into(compiled, std::move(lowered.module), expansion, project, options, diagnostics);
    return compiled;
}

}  // namespace wrinkle

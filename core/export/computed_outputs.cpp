#include "export/computed_outputs.h"

#include "ir/rewrite.h"
#include "lower/check.h"
#include "lower/lower.h"

namespace wrinkle {
namespace {

// Graph inputs that stay parameters.
using LiveInputs = std::set<std::string>;

// The module without its other parameters, and without marks that only derivatives read.
Module with_constants(Module source, const LiveInputs& live) {
    const Replace replace = [](void* context, Module& target, const Module& from, Id id,
                               std::span<const Id> mapped) -> Id {
        if (from[id].op == Op::detach_ || from[id].op == Op::with_covariance_) return mapped[0];
        if (from[id].op != Op::parameter_) return no_id;
        const Parameter& parameter = target.parameters[from[id].extra];
        if (parameter.graph_input && static_cast<LiveInputs*>(context)->contains(parameter.port))
            return no_id;
        return target.constant(parameter.type,
                               std::span(parameter.value.data(), info(parameter.type).lanes));
    };
    LiveInputs context = live;
    return rebuild(std::move(source), replace, &context);
}

LiveInputs inputs_of(const Module& module) {
    LiveInputs inputs;
    for (const Parameter& parameter : module.parameters)
        if (parameter.graph_input) inputs.insert(parameter.port);
    return inputs;
}

}  // namespace

Module module_for_nodes(const ExportRequest& request, Types& types, Diagnostics& diagnostics) {
    check(request.project, request.registry, types, diagnostics);
    if (diagnostics.has_errors()) return {};
    LowerOptions options;
    options.inline_up_to = options.max_nodes;
    Module module = lower(request.project, types, options, diagnostics).module;
    if (diagnostics.has_errors()) return {};
    const LiveInputs live = inputs_of(module);
    return with_constants(std::move(module), live);
}

ComputedOutputs computed_outputs(const Module& module,
                                 const std::function<bool(const ModuleOutput&)>& is_computed) {
    ComputedOutputs divided;
    std::vector<ModuleOutput> computed;
    std::vector<Id> baked;
    for (const ModuleOutput& output : module.outputs) {
        if (is_computed(output)) {
            computed.push_back(output);
        } else {
            baked.push_back(output.value);
            divided.baked.insert(output.name);
        }
    }
    LiveInputs live = inputs_of(module);
    const std::vector<bool> reached = reachable(module, baked);
    for (Id id = 1; id < module.size(); ++id)
        if (reached[id] && module[id].op == Op::parameter_)
            live.erase(module.parameters[module[id].extra].port);
    Module rest = module;
    rest.outputs = std::move(computed);
    divided.module = with_constants(std::move(rest), live);
    return divided;
}

}  // namespace wrinkle

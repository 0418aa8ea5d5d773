// Divides the outputs of a graph into those that nodes of a host compute and those that are baked.
#pragma once

#include <functional>
#include <set>
#include <string>

#include "export/export.h"
#include "ir/module.h"
#include "lower/types.h"

namespace wrinkle {

// Returns the graph as a module in which inputs of the graph are parameters, and other numbers are
// constants. Errors are appended.
Module module_for_nodes(const ExportRequest& request, Types& types, Diagnostics& diagnostics);

struct ComputedOutputs {
    Module module;                // the outputs that nodes compute
    std::set<std::string> baked;  // names of the others
};

// An input of the graph that a baked output reads is a constant of the module, its default: a map
// does not follow it.
ComputedOutputs computed_outputs(const Module& module,
                                 const std::function<bool(const ModuleOutput&)>& is_computed);

}  // namespace wrinkle

// Compiles a project to a module that can be written as GLSL or evaluated: check, lower,
// expand (and bake parameters), explicit lod.
#pragma once

#include "ir/expand.h"
#include "lower/lower.h"

namespace wrinkle {

struct MaterialOptions {
    bool uniform_parameters = false;   // false: parameters become literals (graph inputs never do)
    bool given_differentials = false;  // dx, dy come with the point, samples have an explicit lod
    bool vertex_tangents = true;       // false: --no-tangents
    Covariances covariances = Covariances::dropped;  // `kept` for plan_maps() only (bake/maps.h)
    bool reachable_only = false;  // check only nodes that the outputs need (live preview)
    // The program that runs the module and executes every call of a sub-graph separately ("eval",
    // "render"): too many calls are an error (lower/reachable.h). "": none, as for generated
    // source.
    std::string runs_calls = {};
    LowerOptions lower = {};
};

struct Compiled {
    Module module;
    std::vector<NodePlace> places;  // by index in module.nodes
    bool ok = false;                // false: an error was reported; the module is not to be used
    bool over_limit = false;        // that error is the one of LowerOptions::max_values
};

// Compiles nothing if `diagnostics` has an error already.
Compiled compile_material(const Project& project, const Registry& registry,
                          const MaterialOptions& options, Diagnostics& diagnostics);

}  // namespace wrinkle

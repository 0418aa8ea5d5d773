// From a project to a module that can be written as GLSL or evaluated, in one call:
// check, lower, bake, expand, explicit lod.
#pragma once

#include "ir/expand.h"
#include "lower/lower.h"

namespace wrinkle {

struct MaterialOptions {
    bool uniform_parameters = false;   // false: parameters become literals (graph inputs never do)
    bool given_differentials = false;  // dx, dy come with the point, samples have an explicit lod
    bool vertex_tangents = true;       // false: --no-tangents
    Covariances covariances = Covariances::dropped;  // kept for plan_maps() alone (bake/maps.h)
    bool reached_only = false;  // judge only what the outputs need (live preview)
    // Who runs the module, every call of a sub-graph on its own ("eval", "render"): refused where
    // there are too many (lower/expanded_calls.h). "": nobody, as for a text.
    std::string runs_calls = {};
    LowerOptions lower;
};

struct Compiled {
    Module module;
    std::vector<NodePlace> places;  // of module.nodes
    bool ok = false;                // false: an error was reported; the module is not to be used
    bool over_limit = false;        // that error is of LowerOptions::max_values
};

// Compiles nothing when `diagnostics` holds an error already.
Compiled compile_material(const Project& project, const Registry& registry,
                          const MaterialOptions& options, Diagnostics& diagnostics);

}  // namespace wrinkle

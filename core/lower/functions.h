// Selects the files of a project that become functions; the others are inlined at each use.
// Internal to core/lower.
//
// The rule, for all lowering of sub-graphs:
//   1. All files are inlined if the graph has at most LowerOptions::inline_up_to nodes after that,
//      or if a node has its own base, reads a field or computes the variance of a normal: these
//      depend on values beyond the boundary of a sub-graph.
//   2. Otherwise each file with two or more uses is a function, unless one of its used inputs or
//      outputs is a derivative or a material, or one of its used outputs an image (those are not
//      numbers), or functions would nest more than `deepest` deep.
//   3. Only build(), which may be a plugin's code, shows that a node computes a variance, so
//      lower() then discards its module and lowers the graph again with all files inlined.
//
// In small graphs inlining gives the best shaders: layers on one frame add as 2-vectors, constants
// fold across files, and drivers inline anyway.
#pragma once

#include <algorithm>
#include <vector>

#include "lower/lower.h"

namespace wrinkle {

struct FunctionPlan {
    static constexpr uint32_t deepest = 40;
    struct File {
        bool function = false;
        std::vector<bool> outputs, inputs;  // needed by some use, in the document's order
    };
    std::vector<File> files;  // by file of the project

    bool any() const {
        return std::any_of(files.begin(), files.end(), [](const File& f) { return f.function; });
    }
};

// `outputs` are the requested outputs of the top graph. Linear in the files.
FunctionPlan plan_functions(const Project& project, const Types& types, const LowerOptions& options,
                            const std::vector<uint32_t>& outputs);

}  // namespace wrinkle

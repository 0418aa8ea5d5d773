// Selects the files of a project that are compiled once, as functions, and those that are inlined
// at each use. Internal to core/lower.
//
// A graph that is small after complete inlining is inlined: shaders are at their best so (layers on
// one frame add as 2-vectors, constants fold across files), and drivers inline anyway. In a larger
// one a file with two or more uses becomes a function.
//
// Always inlined are:
//   * files with used inputs or outputs of type derivative, or used image outputs: those are not
//     numbers,
//   * files in which functions are nested more than `deepest` deep,
//   * all files of a project in which a node has its own base or reads a field: both depend on
//     values beyond a sub-graph's boundary.
//
// lower() starts again without functions if an output needs the variance of a normal
// (ir/normal_variance.h).
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

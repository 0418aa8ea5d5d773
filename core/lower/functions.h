// Which files of a project are compiled once, as functions, and which are written out at each use.
// For core/lower alone.
//
// A graph that is small with everything written out is written out: shaders are at their best so
// (layers on one frame add as 2-vectors, constants fold through), and drivers inline anyway. In a
// larger one a file that is used at two places or more becomes a function.
//
// Written out everywhere are:
//   * files with inputs or outputs of type derivative or image outputs that are used: those are no
//     numbers,
//   * files in which functions stand more than `deepest` deep,
//   * everything in a project where a node says a base of its own, or reads a field: both look
//     through a sub-graph's border.
//
// lower() has no functions either where the variance of a normal is asked for
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
        std::vector<bool> outputs, inputs;  // that some use needs, in the document's order
    };
    std::vector<File> files;  // by file of the project

    bool any() const {
        return std::any_of(files.begin(), files.end(), [](const File& f) { return f.function; });
    }
};

// `outputs`: of the top graph, those that are asked for. Linear in the files.
FunctionPlan plan_functions(const Project& project, const Types& types, const LowerOptions& options,
                            const std::vector<uint32_t>& outputs);

}  // namespace wrinkle

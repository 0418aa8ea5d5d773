// The material of a regression case, compiled for the checks of the case.
#pragma once

#include <optional>

#include "cli/material_run.h"
#include "cli/test_case.h"

namespace wrinkle::cli {

struct CaseMaterial {
    CommonOptions common;  // with the preset and the values of the case
    // Runs with given and screen differentials; only those that the checks of the case need.
    std::optional<MaterialRun> given, screen;
    Shader shader;  // the function form; empty without `screen`
    TextureStore textures;
    double compile_ms = 0;  // time to compile `screen` and emit `shader`
};

// Returns the path of a preset file of the case, or the name of a preset of the graph.
std::string preset_of(const TestCase& test);

// Returns the path of the node of each line of `shader`; "" without one.
std::vector<std::string> nodes_of_lines(const CaseMaterial& material);

// "cannot be run: " with the first error.
std::string cannot_run(const Diagnostics& diagnostics);

// Reports an error if `file`, which is derived from the name of the test, is outside the root after
// links are resolved. The same rule applies to files that a graph names.
void refuse_outside(const TestCase& test, const std::filesystem::path& file,
                    const CommonOptions& common, Diagnostics& diagnostics);

// Reports problems of the graph, its images, and the preset and values of the case.
CaseMaterial compile_case(const TestCase& test, const ReadGraph& graph, const Registry& registry,
                          const CommonOptions& common, Diagnostics& diagnostics);

}  // namespace wrinkle::cli

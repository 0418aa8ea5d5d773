// One run of a graph (of a sweep, or the only one) on its way to numbers, text or pixels.
#pragma once

#include <string>

#include "cli/compile.h"
#include "cli/textures.h"
#include "gpu/material.h"

namespace wrinkle::cli {

struct MaterialRun {
    Project project;    // with the values of --set
    Compiled compiled;  // baked; `ok` is false when a problem was reported
};

// Reads the file once and compiles it for every run; up to the first run with an error.
std::vector<MaterialRun> compile_runs(const std::string& file, const CommonOptions& common,
                                      const Registry& registry, const Overrides& overrides,
                                      bool given_differentials, Diagnostics& diagnostics);

// The function form with differentials from the screen, as `wrinkle compile` writes it by default.
Shader emit_function(const MaterialRun& run, const std::string& name, Diagnostics& diagnostics);

}  // namespace wrinkle::cli

// Compiles graphs for evaluation, rendering or baking: once, or once per run of a sweep.
#pragma once

#include <functional>
#include <string>

#include "cli/session.h"
#include "compile/shader.h"
#include "cpu/texture_store.h"

namespace wrinkle::cli {

struct MaterialRun {
    Project project;    // with the values of --preset and --set applied
    Compiled compiled;  // baked parameters; `ok` is false if a problem was reported
};

// A graph as read, and the problems of reading it.
struct ReadGraph {
    Project project;
    Diagnostics problems;
};

// Callback for a compiled run and its index from 0. The run is destroyed after the call.
using UseRun = std::function<void(size_t, const MaterialRun&, Diagnostics&)>;

// Reads the file once, then compiles each run and passes it to `use` before the next is compiled,
// so that a sweep needs the memory of one run. Stops at the first run with an error. `options` get
// vertex_tangents from `common`. If `double_sided` names a mesh with visible back faces, a graph
// that does not set "back_faces" uses the rule `flip`, which is reported as a warning.
void compile_runs(const std::string& file, const CommonOptions& common, const Registry& registry,
                  const Overrides& overrides, MaterialOptions options, const UseRun& use,
                  Diagnostics& diagnostics, const std::string& double_sided = "");

// As above for a graph that was read. A graph with errors is only checked.
void compile_runs(ReadGraph graph, const CommonOptions& common, const Registry& registry,
                  const Overrides& overrides, MaterialOptions options, const UseRun& use,
                  Diagnostics& diagnostics);

// Emits the function form with screen derivatives, the default of `wrinkle compile`.
Shader emit_function(const MaterialRun& run, const std::string& name, Diagnostics& diagnostics);

}  // namespace wrinkle::cli

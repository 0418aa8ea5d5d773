// Graphs compiled, as the commands need them for text, numbers or pixels: one, or one for every run
// of a sweep.
#pragma once

#include <functional>
#include <string>

#include "cli/session.h"
#include "compile/shader.h"
#include "compile/textures.h"

namespace wrinkle::cli {

struct MaterialRun {
    Project project;    // with the values of --set
    Compiled compiled;  // baked; `ok` is false when a problem was reported
};

// What is done with a run that compiled, its number from 0; it is gone afterwards.
using UseRun = std::function<void(size_t, const MaterialRun&, Diagnostics&)>;

// What a run computes: with differentials that come with the points, but on the screen. Bakes of
// moments know what varies (covariances_for() in bake/maps.h).
enum class Purpose : uint8_t { eval, render, bake, bake_moments };

// Reads the file once, compiles it for every run and uses each before the next, so that a long
// sweep takes the memory of one; up to the first run with an error. For a mesh named by
// `double_sided`, whose back faces are meant to be seen, a graph that does not set its "back_faces"
// has the rule `flip`, and a warning says so.
void compile_runs(const std::string& file, const CommonOptions& common, const Registry& registry,
                  const Overrides& overrides, Purpose purpose, const UseRun& use,
                  Diagnostics& diagnostics, const std::string& double_sided = "");

// The function form with differentials from the screen, as `wrinkle compile` writes it by default.
Shader emit_function(const MaterialRun& run, const std::string& name, Diagnostics& diagnostics);

}  // namespace wrinkle::cli

// The text on disk, exactly as `wrinkle compile` would write it.
#pragma once

#include <filesystem>

#include "editor/state.h"

namespace wrinkle::editor {

// In the form that the code panel shows: one file, or of the shader form FILE.vert and FILE.frag.
// False, and why in the status, when nothing was written.
bool export_code(State& state, const std::filesystem::path& file);

// Where it goes when nobody says otherwise: beside the graph, "graph.glsl" or "graph".
std::filesystem::path usual_export(const State& state);

}  // namespace wrinkle::editor

// The text on disk, exactly as `wrinkle compile` would write it.
#pragma once

#include <filesystem>

#include "editor/state.h"

namespace wrinkle::editor {

// In the form that the code panel shows: one file, or of the shader form FILE.vert and FILE.frag
// (FILE.frag.spv, FILE.frag.hlsl, ...).
// All of them are written or none is.
TaskOutcome export_code(const CodeJob& job, const Registry& registry,
                        const std::filesystem::path& file);
// The same of the document as it is now, in the background.
void start_code_export(State& state, const std::filesystem::path& file);

// Where it goes when nobody says otherwise: beside the graph, "graph.glsl" or "graph".
std::filesystem::path usual_export(const State& state);

}  // namespace wrinkle::editor

// Writes the source text to disk, exactly as `wrinkle compile` does.
#pragma once

#include <filesystem>

#include "editor/model/session.h"

namespace wrinkle::editor {

// Exports the current document as a background task, in the form of the code panel: one file, or
// for the shader form FILE.vert and FILE.frag (FILE.frag.spv, FILE.frag.hlsl, ...). Writes all
// files or none.
void start_code_export(Session& session, const std::filesystem::path& file);

// Default path: next to the graph, "graph.glsl", or "graph" for the shader form.
std::filesystem::path usual_export(const Session& session);

}  // namespace wrinkle::editor

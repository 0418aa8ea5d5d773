// Writes the source text to disk, exactly as `wrinkle compile` does.
#pragma once

#include <filesystem>

#include "editor/model/session.h"

namespace wrinkle::editor {

// Uses the form of the code panel: writes one file, or for the shader form FILE.vert and FILE.frag
// (FILE.frag.spv, FILE.frag.hlsl, ...). Writes all files or none.
TaskOutcome export_code(const CodeJob& job, const Registry& registry,
                        const std::filesystem::path& file);
// Same for the current document, as a background task.
void start_code_export(Session& session, const std::filesystem::path& file);

// Default path: next to the graph, "graph.glsl", or "graph" for the shader form.
std::filesystem::path usual_export(const Session& session);

}  // namespace wrinkle::editor

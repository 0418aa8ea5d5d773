// Text that the exported modules for three.js share, of WebGL and of WebGPU.
#pragma once

#include <string>
#include <vector>

#include "compile/shader.h"
#include "export/export.h"
#include "export/textures.h"

namespace wrinkle {

// "chipped_paint" becomes "ChippedPaintMaterial".
std::string three_class(const std::string& name);

// Escapes a text for a JavaScript template literal.
std::string template_literal_text(std::string_view text);

// JavaScript: uniforms of the inputs by name, the elements of the array of images, descriptions of
// the inputs, presets.
std::string three_uniforms(const ExportRequest& request, const Reflection& reflection);
std::string three_textures(const std::vector<ExportedTexture>& textures);
std::string three_input_list(const MadeShader& made, const ExportRequest& request);
std::string three_presets(const ExportRequest& request);
// The import of the loader of EXR, "" without such images; and the function that loads the images.
std::string three_imports(const std::vector<ExportedTexture>& textures);
std::string three_loader(const std::vector<ExportedTexture>& textures);
// The function of `displacement` for the vertex stage; an empty source if the graph has none.
Shader three_displacement(const ExportRequest& request, const Reflection& reflection,
                          const Target& target, Diagnostics& diagnostics);

// The module for WebGPURenderer, NAME.webgpu.js. Returns false and appends errors on failure.
bool write_three_webgpu(const ExportRequest& request, const std::vector<ExportedTexture>& textures,
                        const std::filesystem::path& folder, Diagnostics& diagnostics);

}  // namespace wrinkle

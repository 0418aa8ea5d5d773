// The graph of a material of a MaterialX document.
//
// Shading models: standard_surface, gltf_pbr, open_pbr_surface. Constants of the shader and
// interfaces of node graphs become exposed inputs. Images are named relative to the graph. Every
// part without an equivalent is reported: an error if the result would be wrong, a warning if it is
// an approximation. See docs/import.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "graph/document.h"
#include "materialx/document.h"

namespace wrinkle::materialx {

struct MaterialOptions {
    std::filesystem::path source;  // folder of the document
    std::filesystem::path target;  // folder of the graph
    std::string material;          // name of the material; "": the only one
};

struct MaterialGraph {
    wrinkle::Document graph;
    std::vector<std::string> images;  // paths of the files; the graph names them from `target`
};

// Returns std::nullopt after an error.
std::optional<MaterialGraph> material_graph(const Document& document,
                                            const MaterialOptions& options,
                                            Diagnostics& diagnostics);

}  // namespace wrinkle::materialx

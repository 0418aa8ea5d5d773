// Exports a material to a host: a folder with shader text or baked maps, textures in the encodings
// of the host, and a README.txt, which the host's user copies into a project without writing code.
//
// A host is a row of export.cpp, a file with its writer, its page in docs/hosts.md, and its rows in
// tests/export. A target (emit/target.h) is a language; a host uses one of them, or only maps.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "graph/subgraph.h"
#include "mesh/mesh.h"

namespace wrinkle {

class Registry;

inline constexpr uint32_t max_export_size = 8192;  // texels; all outputs are in memory

struct ExportRequest {
    Project project;    // with the values of presets applied
    std::string graph;  // name of its file in messages
    const Registry& registry;
    std::string name;           // an identifier: begins names of files and globals
    const Mesh& mesh;           // with normals; maps need uv0, and tangents unless they are derived
    std::string mesh_name;      // in messages and in the README
    bool double_sided = false;  // back faces are drawn
    uint32_t size = 1024;       // side of baked maps, in texels
};

struct Host {
    std::string_view name;   // "three", as in --to
    std::string_view label;  // "three.js", for display
    std::string_view doc;    // the files that it gets, one line
    // Writes the files to `folder`, which exists and is empty. Returns false and appends an error
    // on failure. An output that the host cannot represent is a warning.
    bool (*write)(const ExportRequest& request, const std::filesystem::path& folder,
                  Diagnostics& diagnostics);
};

std::span<const Host> hosts();  // in the order of `wrinkle export --list`
const Host* find_host(std::string_view name);

// Exports to `folder`, which is created if it does not exist. All files are
// written before the first is moved to its name: an error of the writer leaves `folder` unchanged,
// an error during the moves can leave old and new files mixed. Other files of the folder stay; a
// file that already has its bytes is not touched. `inputs` are not overwritten. Returns the names
// of the files, relative to `folder` and sorted; empty after an error.
std::vector<std::string> export_material(const Host& host, const ExportRequest& request,
                                         const std::filesystem::path& folder,
                                         std::span<const std::string> inputs,
                                         Diagnostics& diagnostics);

}  // namespace wrinkle

// The node group of an export to Blender: outputs that nodes compute exactly and that an input of
// the Principled BSDF takes unchanged; its inputs are those of the graph. The others are baked.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "export/baked_material.h"

namespace wrinkle {

struct BlenderGroup {
    std::set<std::string> outputs;          // that it computes
    std::vector<std::string> input_labels;  // in the order of its inputs
    std::set<std::string> files;            // images of its nodes, below the folder of the export
    // Lines of texts/blender.py.
    std::string inputs_text, nodes_text, outputs_text;
};

// Copies the images that its nodes read to `folder`. Errors are appended.
BlenderGroup blender_group(const ExportRequest& request, const BakedMaterial& baked,
                           const std::filesystem::path& folder, Diagnostics& diagnostics);

}  // namespace wrinkle

// Valid inputs to damage.
#pragma once

#include <string>
#include <vector>

namespace wrinkle::fuzz {

std::vector<std::string> graph_samples();       // those of the folder graphs
std::vector<std::string> mesh_samples();        // small OBJ, .gltf and .glb files
std::vector<std::string> image_samples();       // every format, type and compression
std::vector<std::string> descriptor_samples();  // random choices
std::vector<std::string> listing_samples();     // one built-in node each
std::vector<std::string> bake_part_samples();   // one map; two maps of three UDIM tiles

}  // namespace wrinkle::fuzz

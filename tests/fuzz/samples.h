// Right inputs, to be damaged.
#pragma once

#include <string>
#include <vector>

namespace wrinkle::fuzz {

std::vector<std::string> graph_samples();       // those of the folder graphs
std::vector<std::string> mesh_samples();        // small OBJ, .gltf and .glb files
std::vector<std::string> image_samples();       // every format, type and compression
std::vector<std::string> descriptor_samples();  // random choices

}  // namespace wrinkle::fuzz

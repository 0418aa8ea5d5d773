// Fuzz targets: each accepts any bytes, returns "" or a description of the failure, and does not
// crash.
//
// fuzz_test.cpp runs a fixed number of damaged samples; libfuzzer/main.cpp runs a target in
// libFuzzer.
#pragma once

#include <string>
#include <string_view>

namespace wrinkle::fuzz {

std::string graph(std::string_view bytes);       // JSON of a graph: read, edited, compiled
std::string mesh(std::string_view bytes);        // an OBJ, .gltf or .glb file
std::string image(std::string_view bytes);       // an image file of any format
std::string descriptor(std::string_view bytes);  // choices made while a plugin is described
std::string listing(std::string_view bytes);     // listing of a plugin's process or manifest
std::string calls(std::string_view bytes);       // recorded calls of a plugin's build()
std::string bake_part(std::string_view bytes);   // bake.json of a part of a bake, no checksum

}  // namespace wrinkle::fuzz

// What is tried with any bytes at all. Each answers "" or what went wrong, and does not crash.
//
// A test plays a fixed number of damaged samples (fuzz_test.cpp); libFuzzer may play as many as it
// likes (libfuzzer/main.cpp).
#pragma once

#include <string>
#include <string_view>

namespace wrinkle::fuzz {

std::string graph(std::string_view bytes);       // a graph's text: read, edited, compiled
std::string mesh(std::string_view bytes);        // an OBJ, .gltf or .glb file
std::string image(std::string_view bytes);       // an image file of any format
std::string descriptor(std::string_view bytes);  // choices made while a plugin is described
std::string listing(std::string_view bytes);     // what a plugin's process or manifest lists
std::string calls(std::string_view bytes);       // recorded calls of a plugin's build()
std::string bake_part(std::string_view bytes);   // bake.json of a part of a bake, without its sum

}  // namespace wrinkle::fuzz

// A full-screen pass over a curved sheet, the same for OpenGL, WebGL 2, WebGPU and Godot, and the
// image that they read.
#pragma once

#include <string>

#include "emit/emit.h"
#include "image/mips.h"

namespace wrinkle::test {

inline constexpr int pass_size = 64;  // pixels in each direction

// The vertex shader of a triangle that covers the screen.
std::string pass_vertex(const Target& target);

// Calls a shader in function form with given differentials at every point of the sheet. Output
// number `output` is written to the color: a normal n as 0.5 + 0.5 n, else 0.5 + 0.5 x.
std::string pass_fragment(const Shader& shader, size_t output);

// The same pass in WGSL: a module with the entry points pass_vertex and pass_fragment.
std::string pass_module(const Shader& shader, size_t output);

// The same pass as a shader of a canvas item in Godot 3.
std::string pass_canvas(const Shader& shader, size_t output);

// A smooth image of half floats, usable as a normal map, a height and a color.
const MipChain& pass_picture();

}  // namespace wrinkle::test

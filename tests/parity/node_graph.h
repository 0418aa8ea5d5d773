// A graph around one node, written for a test: each of its inputs is left alone, given a number in
// its range, or driven by something that varies over the surface; every output is an output of the
// graph ("out_NAME"). Made from the descriptor alone, so a new node is tested when it is listed.
#pragma once

#include <random>
#include <string>

#include "image/mips.h"
#include "lower/material.h"
#include "registry/registry.h"

namespace wrinkle::test {

enum class Inputs : uint8_t {
    defaults,  // images and what else is required are given all the same
    numbers,
    zeros,
    wires,
    mixed,
};

// The text of the graph. Images are named "a.exr" and "b.exr".
std::string graph_around(const NodeType& type, Inputs inputs, std::mt19937& random);

// The built-in nodes and those of the example plugins.
const Registry& all_nodes();

// A folder with files of the names that graphs use; their contents are never read.
std::string image_folder();

struct Subject {
    std::string text;
    Project project;
    Compiled compiled;  // parameters uniform, differentials given
};

// Draws graphs until one is legal (a frame must fit its scale); a test failure when none is.
Subject compile_around(const NodeType& type, Inputs inputs, unsigned seed);

// The textures of both back ends: floats, odd sizes, mips.
const MipChain& test_image(const std::string& file);

}  // namespace wrinkle::test

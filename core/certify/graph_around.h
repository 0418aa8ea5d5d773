// A graph around one node: each of its inputs is left alone, given a number in its range, or driven
// by something that varies over the surface; every output is an output of the graph ("out_NAME").
// Made from the descriptor alone, so a new node is covered when it is listed.
#pragma once

#include <random>
#include <string>

#include "registry/registry.h"

namespace wrinkle::certify {

enum class Inputs : uint8_t {
    defaults,  // images and what else is required are given all the same
    numbers,
    zeros,
    wires,
    mixed,
};
std::string_view words(Inputs inputs);  // "with default inputs"

// The text of the graph. Images are named "a.exr" and "b.exr"; what drives inputs are built-in
// nodes.
std::string graph_around(const NodeType& type, Inputs inputs, std::mt19937& random);

}  // namespace wrinkle::certify

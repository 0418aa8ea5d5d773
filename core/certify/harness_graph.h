// Generates a graph around one node: each input has its default, a number in its range, or a link
// to nodes that vary over the surface; every output is an output of the graph ("out_NAME"), of a
// material some channels ("out_NAME_CHANNEL").
// Generated only from the descriptor, so a new node is covered as soon as it is registered.
#pragma once

#include <random>
#include <string>

#include "registry/registry.h"

namespace wrinkle::certify {

enum class Inputs : uint8_t {
    defaults,  // images and other required inputs are set
    numbers,
    zeros,
    wires,
    mixed,
};
std::string words(Inputs inputs);  // "with default inputs", ...

// Returns the JSON of the graph. Images are named "a.exr" and "b.exr"; linked nodes are built-in
// nodes.
std::string harness_graph(const NodeType& type, Inputs inputs, std::mt19937& random);

}  // namespace wrinkle::certify

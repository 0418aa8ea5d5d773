// Color ramps: node types with a number `factor`, a count `stops` and, for each stop K from 1 on, a
// number `position_K` and a color `color_K`, such as the built-in `ramp`.
//
// Edits take the index of a stop, from 0. Wires of a stop move with it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "graph/document.h"
#include "registry/registry.h"

namespace wrinkle::editor {

struct RampStop {
    double position = 0;
    std::array<double, 3> color{};  // linear
};

bool is_ramp(const NodeType* type);  // false for nullptr
// Returns true for a position or a color of a ramp.
bool is_stop_port(const NodeType& type, std::string_view port);
std::string position_port(size_t stop);  // "position_1" for 0
std::string color_port(size_t stop);

// Returns the stops that are used. A value on a wire has the default of its port.
std::vector<RampStop> stops_of(const Node& node, const NodeType& type);
size_t max_stops(const NodeType& type);

// Adds a stop before the first one with a greater position; nothing if the ramp is full.
Document with_stop(const Document& document, const Node& node, const NodeType& type,
                   const RampStop& stop);
// Returns the index that with_stop() gives a stop.
size_t index_of_stop(const std::vector<RampStop>& stops, double position);
// Removes a stop; nothing if only as many are left as the ramp needs.
Document without_stop(const Document& document, const Node& node, const NodeType& type,
                      size_t stop);
// Moves a stop, between its neighbours.
Document with_stop_at(const Document& document, const Node& node, const NodeType& type, size_t stop,
                      double position);
Document with_stop_color(const Document& document, const Node& node, const NodeType& type,
                         size_t stop, const std::array<double, 3>& color);

}  // namespace wrinkle::editor

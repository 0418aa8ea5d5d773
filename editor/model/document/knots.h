// Knots: the stops of color ramps and the points of curves.
//
// Color ramps: node types with a number `factor`, a count `stops` and, for each stop K from 1 on, a
// number `position_K` and a color `color_K`, such as the built-in `ramp`. Curves: node types with a
// number `value`, a count `points` and, for each point K, a vec2 `point_K`, such as the built-in
// `curve`. Positions ascend. Edits take the index of a stop or point, from 0; wires move with it.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "editor/model/document/repeated.h"

namespace wrinkle::editor {

RepeatedPorts ramp_ports(const NodeType* type);   // none: not a ramp
RepeatedPorts curve_ports(const NodeType* type);  // none: not a curve
inline bool is_ramp(const NodeType* type) {
    return bool(ramp_ports(type));
}
inline bool is_curve(const NodeType* type) {
    return bool(curve_ports(type));
}
// Returns true for a port of a stop or of a point.
bool is_knot_port(const NodeType& type, std::string_view port);
// Returns the input that a ramp or a curve maps: "factor" or "value".
std::string_view mapped_port(const NodeType& type);

struct RampStop {
    double position = 0;
    std::array<double, 3> color{};  // linear
};
// Return the stops or points that are used. A value on a wire has the default of its port.
std::vector<RampStop> stops_of(const Node& node, const NodeType& type);
std::vector<glm::dvec2> points_of(const Node& node, const NodeType& type);

// Returns the index of the first greater one of the ascending positions; their count if none is.
size_t index_after(const std::vector<double>& positions, double position);
std::vector<double> positions_of(const std::vector<RampStop>& stops);
std::vector<double> positions_of(const std::vector<glm::dvec2>& points);

// Add a stop or a point at its position; nothing if all are used.
Document with_stop(const Document& document, const Node& node, const NodeType& type,
                   const RampStop& stop);
Document with_point(const Document& document, const Node& node, const NodeType& type,
                    glm::dvec2 point);
// Move a stop or a point, clamped between its neighbours; at the ends, to 0 and 1.
Document with_stop_at(const Document& document, const Node& node, const NodeType& type, size_t stop,
                      double position);
Document with_point_at(const Document& document, const Node& node, const NodeType& type,
                       size_t point, glm::dvec2 to);
Document with_stop_color(const Document& document, const Node& node, const NodeType& type,
                         size_t stop, const std::array<double, 3>& color);

}  // namespace wrinkle::editor

// Handles of a node in the 2D view: points of uv that set values of its ports.
//
//   handle              ports                                  point
//   center, a, b        a vec2 of that name                    the value
//   size                a vec2 `size`, width and height        the corner at the upper right
//   size, radius        a float; with a vec2 `size`, `radius`  as far from the center, to the
//                       is of the corners: no handle           right
//   rotation, angle     a float of unit "deg"                  above, outside of the others
//
// All but points are relative to `center`, and turn with `rotation`; without a center there are
// none. The node must have a port `uv` that reads the surface's: with a wire from another node it
// has no handles. A value on a wire has no handle, nor have those that depend on it.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "graph/document.h"
#include "registry/registry.h"

namespace wrinkle::editor {

struct UvHandle {
    enum class Kind : uint8_t { point, corner, distance, angle };  // rows of the table
    Kind kind = Kind::point;
    std::string_view port;  // name of the port
    glm::dvec2 at;          // uv
    bool operator==(const UvHandle&) const = default;
};

// Returns the handles; the center is the first, if the node has one.
std::vector<UvHandle> uv_handles(const Node& node, const NodeType& type);

// Sets the port so that its handle is at `to`, or as near as its range permits. A new
// angle is within 180 degrees of the old one. `snaps`: points, sizes and radii become multiples of
// 0.05, angles of 15 degrees.
Document with_handle_at(const Document& document, const Node& node, const NodeType& type,
                        std::string_view port, glm::dvec2 to, bool snaps);

// Corners of the box that the vec2 `size` describes, anticlockwise from the upper right; empty if
// the node has none.
std::vector<glm::dvec2> box_of_handles(const Node& node, const NodeType& type);

}  // namespace wrinkle::editor

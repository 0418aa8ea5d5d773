// The built-in shapes, by name. Centred at the origin, +y up, front towards +z. All have normals,
// tangents, color0 white, uv0 and uv1, and enough triangles for smooth silhouettes.
//
// uv0 covers a part of [0, 1]^2 without overlap, so a uv identifies one surface point. Seen from
// outside, u runs to the right and v up. uv1 is uv0 rotated by 30 degrees about (0.5, 0.5) and
// scaled by 2 (it leaves [0, 1]): a second set for layers that must not align with the first.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "mesh/mesh.h"

namespace wrinkle {

struct Shape {
    std::string_view name;
    std::string_view doc;  // one sentence
    Mesh (*make)();
};

//   sphere    radius 1. u = longitude, seam at the back (-z), 0.5 at the front; v = latitude.
//   plane     x and y in [-1, 1], normal +z, one uv square. Open: it has a border.
//   cube      x, y, z in [-1, 1], hard edges. Squares of side 1/3, from the bottom left three in
//             a row: +x, +y, +z; above them -x, -y, -z. Nothing above v = 2/3. u runs along
//             -z, +x, +x in the first row and along +z, +x, -x in the second.
//   cylinder  radius 1, y in [-1, 1], axis y. Side: v in [0, 0.5], u as on the sphere. Top and
//             bottom: discs of radius 0.24 round (0.25, 0.75) and (0.75, 0.75).
//   torus     ring radius 0.7 in the xz plane, tube radius 0.3. u round the ring as on the sphere,
//             v round the tube, 0.5 at the outer rim.
//   teapot    Newell's patches at 0.45 of their published size: 1.42 high, spout towards +x, handle
//             towards -x, seam at -z. u = longitude; v from below upwards: bottom [0, 0.14], body
//             to 0.48, rim to 0.54, lid [0.56, 0.82]. Above 0.84 the handle (u < 0.5) and the
//             spout, u along, v round them. Open as the original: the lid is a separate surface,
//             handle and spout end within the body.
std::span<const Shape> shapes();  // the first is the default
bool is_shape(std::string_view name);
std::optional<Mesh> make_shape(std::string_view name);  // thousands of vertices

}  // namespace wrinkle

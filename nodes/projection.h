// Planes and axes that projections, triplanar maps, cube maps and decals share. Right-handed object
// space.
//
// A lookup is a uv on a plane. It is oriented as seen from outside that side: u to the right, v up,
// not mirrored. On the negative sides u (v for side y) and its slope are negated.
//   side x   u = -z on the positive side, +z on the negative; v = y
//   side y   u = x; v = -z on the positive side, +z on the negative
//   side z   u = +x on the positive side, -x on the negative; v = y
// These are the faces of an OpenGL cube map.
#pragma once

#include "wrinkle/math.h"

namespace wrinkle::nodes {

inline constexpr const char* axis_names[] = {"x", "y", "z"};
inline constexpr char point_doc[] = "The place to project; object space unless wired otherwise";

struct Planes {
    sdk::vec2 x, y, z;
};
// Returns the lookups of a point; `side` is +1 or -1 by axis.
Planes planes_at(sdk::vec3 point, sdk::vec3 side);
// Returns +1 or -1 by axis: the side of each plane that is visible when looking along -direction.
sdk::vec3 side_of(sdk::vec3 direction);

// Returns the surface normal as on the front face, undoing a flip by the graph's rule for back
// faces, so that a relief is the same from behind.
sdk::vec3 front_of(sdk::vec3 normal);

// Returns the gradient in space of a height from its slopes on the three planes, each times its
// weight. Golubev (docs/checklists.md), eqs. 46-49; the weights are treated as constant.
sdk::vec3 volume_of(const Planes& slopes, sdk::vec3 side);

// Returns max(|n| - threshold, 0)^sharpness, normalised to sum 1 (I. Castano); 0 for a zero normal.
// Constant under differentiation. Sharpness is 1 to 64, the threshold below 1/sqrt(3).
sdk::vec3 triplanar_weights(sdk::vec3 normal, sdk::Float sharpness, sdk::Float threshold);
// The same with the default threshold, 0.2.
sdk::vec3 triplanar_weights(sdk::vec3 normal, sdk::Float sharpness);

// The side of a cube around the origin that `direction` intersects, with the lookup of `point`. The
// lookup of `direction` itself is within [-depth, depth].
struct CubeFace {
    sdk::vec2 place;   // lookup of the point; u to the right and v up as seen from outside
    sdk::Float depth;  // absolute value of the largest component of `direction`
    sdk::Float index;  // 0 to 5: +x -x +y -y +z -z
};
CubeFace cube_face(sdk::vec3 direction, sdk::vec3 point);

// Unit axes, right-handed: z as given, y as close to `up` as possible; any y if `up` is parallel to
// z.
struct Axes {
    sdk::vec3 x, y, z;
};
Axes axes_of(sdk::vec3 z, sdk::vec3 up);
sdk::vec3 into(const Axes& axes, sdk::vec3 v);

// Converts `way`, an offset from a point on the axis, to the coordinates of a viewer in front: x to
// the right, y along the axis, z towards the viewer. `axis` and `front` have any length.
sdk::vec3 round_place(sdk::vec3 way, sdk::vec3 axis, sdk::vec3 front);
// Returns the angle of such coordinates around the axis, in turns: 0 and 1 at the back, 0.5 in
// front, increasing to the right.
sdk::Float turns_of(sdk::vec3 place);
// Returns that angle as u; v is 0 to 1 from pole to pole.
sdk::vec2 longitude_latitude(sdk::vec3 place);

}  // namespace wrinkle::nodes

// Looking at things from outside: the planes and axes that projections, triplanar maps, cube maps
// and decals share. Right-handed object space.
//
// A plane's lookup is what somebody sees who looks at that side from outside: u to the right, v up,
// never mirrored. On the negative sides one lookup axis is negated, and with it that slope.
//   side x   u = -z on the positive side, +z on the negative; v = y
//   side y   u = x; v = -z on the positive side, +z on the negative
//   side z   u = +x on the positive side, -x on the negative; v = y
// These are the faces of a cube map of OpenGL.
#pragma once

#include "wrinkle/math.h"

namespace wrinkle::nodes {

#define AXES \
    { "x", "y", "z" }
#define POINT_DOC "The place to project; object space unless wired otherwise"

struct Planes {
    sdk::vec2 x, y, z;
};
// The lookups of a point; `side` is +1 or -1 by axis.
Planes planes_at(sdk::vec3 point, sdk::vec3 side);
// +1 or -1 by axis: which side of each plane somebody sees who looks along -direction.
sdk::vec3 side_of(sdk::vec3 direction);

// A normal of the surface, turned or not by the graph's rule for back faces, as the front face has
// it: a relief is the same from behind.
sdk::vec3 front_of(sdk::vec3 normal);

// The gradient in space of a height whose slopes on the three planes are given, each times its
// weight. Golubev, eqs. 46-49: weights count as constant.
sdk::vec3 volume_of(const Planes& slopes, sdk::vec3 side);

// max(|n| - threshold, 0)^sharpness, of sum 1 (I. Castano); all 0 for a zero normal. Constant under
// differentiation. Sharpness is 1 to 64, the threshold below 1/sqrt(3).
sdk::vec3 triplanar_weights(sdk::vec3 normal, sdk::Float sharpness, sdk::Float threshold);
// With the usual threshold, 0.2.
sdk::vec3 triplanar_weights(sdk::vec3 normal, sdk::Float sharpness);

// The side of a cube round the origin that `direction` meets.
struct CubeFace {
    sdk::vec2 place;   // u to the right and v up as seen from outside, times `depth`
    sdk::Float depth;  // the largest component, its size
    sdk::Float index;  // 0 to 5: +x -x +y -y +z -z
};
CubeFace cube_face(sdk::vec3 direction, sdk::vec3 point);

// Unit axes, right-handed: z as given, y as near to `up` as can be; any y where up is parallel.
struct Axes {
    sdk::vec3 x, y, z;
};
Axes axes_of(sdk::vec3 z, sdk::vec3 up);
sdk::vec3 into(const Axes& axes, sdk::vec3 v);

// `way`, from a place on an axis, as somebody sees it who looks at the axis from the front: x to
// the right, y along the axis, z to the front. Any lengths.
sdk::vec3 round_place(sdk::vec3 way, sdk::vec3 axis, sdk::vec3 front);
// Of such a place: 0 to 1 round the axis, to the right from behind, 0.5 in front.
sdk::Float turns_of(sdk::vec3 place);
// And 0 to 1 from pole to pole as v.
sdk::vec2 longitude_latitude(sdk::vec3 place);

}  // namespace wrinkle::nodes

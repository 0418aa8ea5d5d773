// The bumpy ball: an object-space normal map of a sphere of radius 1, laid out as core/mesh lays
// out its own: u is the longitude with 0.5 at +z and u growing to the right, v the latitude from
// -y to +y.
#pragma once

#include <array>

namespace wrinkle::textures {

using Vector = std::array<double, 3>;

// The point of the unit sphere at u, v.
Vector sphere_point(double u, double v);

// The unit normal of the ball whose radius is 1 + bumps at the point p of the unit sphere: rounded
// bosses at the twenty corners of a dodecahedron and dimples at the twelve of an icosahedron. It is
// normalize(p - the bumps' tangential gradient), which leaves out terms of second order in them.
Vector ball_normal(const Vector& p);

}  // namespace wrinkle::textures

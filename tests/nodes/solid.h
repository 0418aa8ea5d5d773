// Evaluates nodes in space: on the unit sphere, or on planes of any orientation; and computes the
// normal of such a surface after displacement, by central differences. Oracle of projections.
#pragma once

#include <functional>

#include "nodes/plane.h"
#include "support/angle.h"

namespace wrinkle::test {

struct Vector {
    double x = 0, y = 0, z = 0;

    double operator[](size_t i) const { return i == 0 ? x : i == 1 ? y : z; }
};
Vector operator+(Vector a, Vector b);
Vector operator-(Vector a, Vector b);
Vector operator*(Vector a, double k);
double dot(Vector a, Vector b);
Vector cross(Vector a, Vector b);
Vector unit(Vector a);
Vector vector_of(const std::vector<double>& lanes);

struct Place {
    Vector position, normal;
};
// Evenly distributed over the unit sphere.
std::vector<Place> on_sphere(int count);
// The six sides +x -x +y -y +z -z.
Vector side(int index);
// Right and up directions in a view of a side from outside; y is up, seen from above -z, from below
// +z.
struct Seen {
    Vector right, up;
};
Seen seen_from_outside(int index);

// The output at each place, with pixels `size` wide.
std::vector<std::vector<double>> values_on(const Scene& scene, const std::vector<Place>& places,
                                           double size = pixel);
std::vector<double> value_on(const Scene& scene, Place place, double size = pixel);

// The normal at `place` of the unit sphere (or of its tangent plane) displaced outward by a height.
Vector displaced_on_sphere(Vector place, const std::function<double(Vector)>& height);
Vector displaced_on_plane(Place place, const std::function<double(Vector)>& height);

}  // namespace wrinkle::test

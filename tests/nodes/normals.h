// Tangent-space normals by tilt and azimuth in degrees, the normal of the sum of two heights, and a
// blend node evaluated at many pairs of normals.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace wrinkle::test {

using Normal = std::array<double, 3>;

Normal tilted(double tilt, double azimuth);
double angle_between(const Normal& a, const Normal& b);

// Adds the planes perpendicular to a and to b as heights and takes the cross product of two edges
// of the result. Uses neither slopes nor gradients.
Normal of_added_heights(const Normal& a, const Normal& b);

struct Pair {
    Normal base, detail;
    Normal other{0, 0, 1};  // a third layer, if any
};

// The output "node.port" of a graph that reads pairs as `surface.position` and `surface.view`, and
// the third layer as "third.vector".
std::vector<Normal> read(const std::string& nodes, const std::string& output,
                         const std::vector<Pair>& pairs);
// A node with the ports base, detail and normal; `in` are further members of its "in".
std::vector<Normal> blended(const std::string& type, const std::string& in,
                            const std::vector<Pair>& pairs);
// (base with detail) with other, and base with (detail with other).
std::vector<Normal> blended_left(const std::string& type, const std::vector<Pair>& pairs);
std::vector<Normal> blended_right(const std::string& type, const std::vector<Pair>& pairs);

// Tilts and azimuths are uniformly distributed, the tilts from 0 to this many degrees.
std::vector<Pair> random_pairs(size_t count, double tilt);
std::vector<Pair> swapped(std::vector<Pair> pairs);

struct Angles {
    double mean = 0, max = 0;
};
Angles angles(const std::vector<Normal>& a, const std::vector<Normal>& b);
std::vector<Normal> sums(const std::vector<Pair>& pairs);  // of_added_heights, base and detail

}  // namespace wrinkle::test

// Oracle of the property tests: smooth surfaces given by formula, the values that a rasteriser
// gives at a point, and the normal after displacement. Independent of the implementation: uses no
// surface gradients; every derivative is a central difference in double.
#pragma once

#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "ir/interpret.h"
#include "support/angle.h"

namespace wrinkle::test {

using glm::dmat2;
using glm::dvec2;
using glm::dvec3;

// Functions of the parameters (s, t). Normals are unit and outward. uv0 and uv1 have approximately
// the unit of lengths.
struct Surface {
    const char* name = "";
    double radius = 1;  // smallest radius of curvature; limits the size of displacements
    std::function<dvec3(dvec2)> position;
    std::function<dvec3(dvec2)> normal;
    std::function<dvec2(dvec2)> uv0;
    std::function<dvec2(dvec2)> uv1;
};

Surface sphere();
Surface torus();
Surface tilted_plane();
// Both are developable. uv0 = uv0_of_length * (lengths on the unrolled surface) + an offset.
Surface plane_with(dmat2 uv0_of_length);
Surface cylinder_with(dmat2 uv0_of_length);

// Returns the derivative of f(at + k * direction) by k at 0: a central difference of fourth order.
template <class F>
auto along(const F& f, dvec2 at, dvec2 direction, double step) {
    const auto pair = [&](double k) { return f(at + direction * k) - f(at - direction * k); };
    return (pair(step) * 8.0 - pair(2 * step)) / (12 * step);
}

// Position, normal, tangent (of uv0), uv0, uv1 and facing = 1.
Surroundings values_at(const Surface& surface, dvec2 st);
// The same with differentials to the next pixel; the columns of `pixel` are those of (s, t) in x
// and in y.
Surroundings point_at(const Surface& surface, dvec2 st, const dmat2& pixel);

// Returns the outward unit normal of the surface position + height * normal.
dvec3 displaced_normal(const Surface& surface, const std::function<double(dvec2)>& height,
                       dvec2 st);

struct Sample {
    dvec2 st;
    dmat2 pixel;  // see point_at(); well conditioned, determinants of alternating sign
};
std::vector<Sample> samples(int count, unsigned seed);

dvec3 to_vec3(const Lanes& lanes);
void set(Surroundings& around, SurfaceInput input, std::initializer_list<double> lanes,
         Variant variant = Variant::value);
void set3(Surroundings& around, SurfaceInput input, dvec3 v, Variant variant = Variant::value);
dvec3 normal_of(const Surroundings& around);

// An input that surfaces do not set; tests may choose its value.
constexpr SurfaceInput free_vector = SurfaceInput::color0_;
void set_free(Surroundings& around, dvec3 v);

}  // namespace wrinkle::test

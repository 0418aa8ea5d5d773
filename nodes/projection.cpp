#include "nodes/projection.h"

#include "nodes/constants.h"
#include "wrinkle/surface.h"

namespace wrinkle::nodes {
using namespace sdk;

Planes planes_at(vec3 point, vec3 side) {
    return {{-side.x() * point.z(), point.y()},
            {point.x(), -side.y() * point.z()},
            {side.z() * point.x(), point.y()}};
}

vec3 side_of(vec3 direction) {
    return {named("side_x", sign_nonzero(direction.x())),
            named("side_y", sign_nonzero(direction.y())),
            named("side_z", sign_nonzero(direction.z()))};
}

vec3 front_of(vec3 normal) {
    const vec3 front = surface::front_normal;
    return normal * sign_nonzero(dot(front, surface::normal));
}

vec3 volume_of(const Planes& slopes, vec3 side) {
    const auto [x, y, z] = slopes;
    return {y.x() + z.x() * side.z(), x.y() + z.y(), -(x.x() * side.x() + y.y() * side.y())};
}

// min_area() is less than the sum of powers for any unit normal; a zero normal gives 0.
// Precondition: `above` >= 0 and sharpness > 0. So the op is emitted without the guards of pow().
static vec3 shares(vec3 above, Float sharpness) {
    const vec3 powers = named("powers", vec3(emit(WR_OP_pow, {above.id, vec3(sharpness).id})));
    const Float sum = named("sum", powers.x() + powers.y() + powers.z());
    return named("weights", detach(powers / max(sum, min_area())));
}

static vec3 above_threshold(vec3 normal, Float threshold) {
    return named("above", max(abs(normalize(normal)) - vec3(threshold), vec3(0)));
}

vec3 triplanar_weights(vec3 normal, Float sharpness, Float threshold) {
    const vec3 above = above_threshold(normal, threshold);
    // Near the threshold high powers of all three would underflow.
    const Float most = named("most", max(max(above.x(), above.y()), above.z()));
    return shares(divide(above, most), sharpness);
}

vec3 triplanar_weights(vec3 normal, Float sharpness) {
    return shares(above_threshold(normal, 0.2), sharpness);
}

CubeFace cube_face(vec3 direction, vec3 point) {
    const vec3 size = named("size", abs(direction));
    const Bool x = named("on_x", size.x() >= size.y() && size.x() >= size.z());
    const Bool y = named("on_y", size.y() > size.x() && size.y() >= size.z());
    const auto chosen = [&](Float of_x, Float of_y, Float of_z) {
        return select(x, of_x, select(y, of_y, of_z));
    };
    const Float along = named("along", chosen(direction.x(), direction.y(), direction.z()));
    const Float side = named("side", sign_nonzero(along));
    const Float flipped = named("flipped", point.z() * -side);
    const Float right = chosen(flipped, point.x(), point.x() * side);
    return {named("on_face", vec2(right, select(y, flipped, point.y()))),
            named("face_depth", along * side), named("face", chosen(0.5, 2.5, 4.5) - 0.5 * side)};
}

Axes axes_of(vec3 z, vec3 up) {
    const vec3 towards = normalize(z);
    const vec3 wanted = cross(normalize(up), towards);
    const vec3 other = select(abs(towards.x()) < 0.9, vec3(1, 0, 0), vec3(0, 1, 0));
    const vec3 x = normalize(select(dot(wanted, wanted) > 1e-8, wanted, cross(other, towards)));
    return {x, cross(towards, x), towards};
}

vec3 into(const Axes& axes, vec3 v) {
    return {dot(v, axes.x), dot(v, axes.y), dot(v, axes.z)};
}

vec3 round_place(vec3 way, vec3 axis, vec3 front) {
    const Axes axes = axes_of(axis, front);  // z along the axis, y to the front
    const vec3 place = named("place", into(axes, way));
    return {-place.x(), place.z(), place.y()};
}

Float turns_of(vec3 place) {
    return atan(place.x(), place.z()) / two_pi() + 0.5;
}

vec2 longitude_latitude(vec3 place) {
    return {turns_of(place), atan(place.y(), length(place.xz())) / pi() + 0.5};
}

}  // namespace wrinkle::nodes

// Surface gradients and their inputs. The functions record ops; the host computes them
// (docs/surface-gradient.md).
//
// Gradient    the derivative of a height along the surface, a vector in the tangent plane. Sums and
//             multiples of gradients are gradients; their order does not matter.
// Derivative  dh/d(u,v) with its frame; converts to a Gradient.
// Frame       maps a slope in a uv set to a gradient. Valid methods: automatic, exact and pixel
//             with the scale `surface`; automatic, vertex, derived and guess with `unit`.
#pragma once

#include "wrinkle/math.h"

namespace wrinkle::sdk {

// In the order of WR_FRAME_* and WR_SCALE_*.
enum class FrameMethod { automatic, vertex, derived, exact, guess, pixel };
enum class Scale { surface, unit };

class Frame {
public:
    static constexpr uint32_t type = WR_TYPE_frame;
    wr_value id;
    explicit Frame(Raw raw) : id(raw.id) {}
};

// `direction` (object space, any length) is used only by the method `guess`.
inline Frame frame(vec2 uv, FrameMethod method, Scale scale, vec3 direction) {
    const uint32_t extra = WR_FRAME(method, scale);
    if (method == FrameMethod::guess) return Frame(emit(WR_OP_frame, {uv.id, direction.id}, extra));
    return Frame(emit(WR_OP_frame, {uv.id}, extra));
}
inline Frame frame(vec2 uv, Scale scale) {
    return Frame(emit(WR_OP_frame, {uv.id}, WR_FRAME(FrameMethod::automatic, scale)));
}

class Derivative {
public:
    static constexpr uint32_t type = WR_TYPE_derivative;
    wr_value id;
    explicit Derivative(Raw raw) : id(raw.id) {}
    Derivative(vec2 slope, Frame frame)
        : Derivative(emit(WR_OP_derivative, {slope.id, frame.id})) {}
    vec2 slope() const { return vec2(emit(WR_OP_slope, {id})); }  // dh/d(u,v)
};

class Base {
public:
    static constexpr uint32_t type = WR_TYPE_base;
    wr_value id = 0;  // 0: base of the node's inputs
    Base() = default;
    explicit Base(Raw raw) : id(raw.id) {}
    // `normal`: value of an input of type Normal, usually called `base`, with surface::normal as
    // default.
    explicit Base(vec3 normal) : Base(emit(WR_OP_base, {normal.id})) {}
};

class Gradient {
public:
    static constexpr uint32_t type = WR_TYPE_gradient;
    wr_value id;
    explicit Gradient(Raw raw) : id(raw.id) {}
    Gradient(Derivative d, Base base = {})
        : Gradient(emit(WR_OP_gradient_from_derivative, {d.id}, base.id)) {}
    static Gradient flat() { return Gradient(emit(WR_OP_gradient_zero, {})); }
    vec3 vector() const { return vec3(emit(WR_OP_gradient_vector, {id})); }  // object space
};

// Returns the slopes of a tangent-space normal (any length, z up), times `strength`.
inline Derivative normal_derivative(vec3 normal, Float strength, Frame frame) {
    return Derivative(emit(WR_OP_normal_derivative, {normal.id, strength.id, frame.id}));
}
// Returns the gradient of a height in object-space length units, positive outward. The host
// differentiates the height.
inline Gradient gradient_from_height(Float height, Base base = {}) {
    return Gradient(emit(WR_OP_gradient_from_height, {height.id}, base.id));
}
// Returns the surface gradient from the gradient of a height in object space.
inline Gradient gradient_from_volume(vec3 gradient, Base base = {}) {
    return Gradient(emit(WR_OP_gradient_from_volume, {gradient.id}, base.id));
}
// Returns the gradient of a perturbed normal (object space, any length). A normal that points
// inward is mirrored at the tangent plane.
inline Gradient gradient_from_normal(vec3 normal, Base base = {}) {
    return Gradient(emit(WR_OP_gradient_from_normal, {normal.id}, base.id));
}
// As gradient_from_normal(), but a normal that points inward is negated.
inline Gradient gradient_from_outward_normal(vec3 normal, Base base = {}) {
    return Gradient(emit(WR_OP_gradient_from_outward_normal, {normal.id}, base.id));
}
// Returns the value, annotated for normal_variance() with its variation within a pixel: a vec2 with
// the covariances (xx, yy, xy), or a vec3 with one variance for all components.
inline vec2 with_covariance(vec2 value, vec3 covariance) {
    return vec2(emit(WR_OP_with_covariance, {value.id, covariance.id}));
}
inline vec3 with_covariance(vec3 value, Float variance) {
    return vec3(emit(WR_OP_with_covariance, {value.id, variance.id}));
}
// Returns the trace of the covariance of the bump's unit normal within a pixel, from the textures
// that the bump reads and from with_covariance().
inline Float normal_variance(Gradient gradient) {
    return Float(emit(WR_OP_normal_variance, {gradient.id}));
}
// Returns that covariance along x and cross(n, x), n the bump's unit normal: (xx, yy, xy), where
// xx + yy = normal_variance(). `x` is a unit vector across n.
inline vec3 normal_covariance(Gradient gradient, vec3 x) {
    return vec3(emit(WR_OP_normal_covariance, {gradient.id, x.id}));
}
// Returns the unit normal in object space.
inline vec3 resolve(Gradient gradient) {
    return vec3(emit(WR_OP_resolve, {gradient.id}));
}

inline Gradient operator+(Gradient a, Gradient b) {
    return Gradient(emit(WR_OP_gradient_add, {a.id, b.id}));
}
inline Gradient operator*(Gradient g, Float factor) {
    return Gradient(emit(WR_OP_gradient_scale, {g.id, factor.id}));
}
inline Gradient operator*(Float factor, Gradient g) {
    return g * factor;
}
inline Gradient operator-(Gradient g) {
    return g * -1;
}
inline Gradient operator-(Gradient a, Gradient b) {
    return a + -b;
}
inline Gradient mix(Gradient a, Gradient b, Float t) {
    return Gradient(emit(WR_OP_gradient_mix, {a.id, b.id, t.id}));
}

}  // namespace wrinkle::sdk

// Surface gradients and what they are made of. The host owns the algebra; a body only says what is
// meant.
//
// Gradient    the change of a height along the surface. Sums and multiples are gradients, in any
//             order.
// Derivative  dh/d(u,v) with its frame; it becomes a Gradient when used as one.
// Frame       what turns a slope in a uv set into a gradient: method and scale must fit (the scale
//             `surface` goes with automatic, exact and pixel, `unit` with automatic, vertex,
//             derived and guess).
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

// `direction` (object space, any length) is used by the method `guess` alone.
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
    wr_value id = 0;  // the surface
    Base() = default;
    explicit Base(Raw raw) : id(raw.id) {}
    // The value of an input of type Normal, by custom named `base`, with surface::normal as
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

// Of a tangent-space normal, any length, z up; its slopes times `strength`.
inline Derivative normal_derivative(vec3 normal, Float strength, Frame frame) {
    return Derivative(emit(WR_OP_normal_derivative, {normal.id, strength.id, frame.id}));
}
// Of a height in object-space length units, positive outward, by its derivative.
inline Gradient gradient_from_height(Float height, Base base = {}) {
    return Gradient(emit(WR_OP_gradient_from_height, {height.id}, base.id));
}
// Of the gradient over space of a height.
inline Gradient gradient_from_volume(vec3 gradient, Base base = {}) {
    return Gradient(emit(WR_OP_gradient_from_volume, {gradient.id}, base.id));
}
// Of a perturbed normal in object space, any length; one that points inward is mirrored outward.
inline Gradient gradient_from_normal(vec3 normal, Base base = {}) {
    return Gradient(emit(WR_OP_gradient_from_normal, {normal.id}, base.id));
}
// One that points inward is reversed instead.
inline Gradient gradient_from_outward_normal(vec3 normal, Base base = {}) {
    return Gradient(emit(WR_OP_gradient_from_outward_normal, {normal.id}, base.id));
}
// The value itself, said to vary within a pixel: a vec2 with the covariances (xx, yy, xy), or a
// vec3 whose lanes all have one variance. normal_variance() counts it.
inline vec2 with_covariance(vec2 value, vec3 covariance) {
    return vec2(emit(WR_OP_with_covariance, {value.id, covariance.id}));
}
inline vec3 with_covariance(vec3 value, Float variance) {
    return vec3(emit(WR_OP_with_covariance, {value.id, variance.id}));
}
// How much the unit normal of a bump varies within a pixel: the trace of its covariance, from the
// pictures that the bump is read from and from with_covariance().
inline Float normal_variance(Gradient gradient) {
    return Float(emit(WR_OP_normal_variance, {gradient.id}));
}
// The unit normal in object space.
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

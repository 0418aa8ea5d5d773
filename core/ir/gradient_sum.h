// A surface gradient under composition. Part of the expansion pass.
//
// Gamma = sum over bases (T s.x + B s.y)  +  eq. 3 of (hx, hy)  +  (g - n (n.g))  +  v + n a,
// stored as its parts: a 2-vector of slopes per tangent basis, one of screen differentials, one
// volume vector, one vector v that adding n a makes tangent. All parts are linear, so layers add
// part by part. Components along n are summed in one float and applied together with n: n (1 + n.g)
// - g.
//
// The slope of a normal is a quotient, -xy/z of one in tangent space, (k n - v)/|k| of one in
// object space. Up to two such terms stay pending, not divided by their depths: resolve multiplies
// n by the depths instead, because positive factors cancel in the final normalize. With a third
// term every term is divided: the product of three small depths overflows, and dividing is then
// cheaper. Pending terms are also stored without their minus sign, so that n - Gamma becomes a sum.
#pragma once

#include <vector>

#include "ir/gradient_frame.h"

namespace wrinkle {

struct Slopes {
    struct Slot {
        FrameKey basis;
        Value slope;  // vec2
    };
    std::vector<Slot> slots;  // at most max_slots; further ones are added to rest
    Value screen;             // vec2 (dh/dx, dh/dy); an empty Value is zero
    Value volume;             // vec3
    Value rest;               // vec3; tangent to the base once `along` times n is added
    Value along;              // float

    bool empty() const { return slots.empty() && !screen && !volume && !rest; }
};

struct GradientSum {
    Slopes flat;
    struct Term {
        Slopes numerator;   // of a slope downhill: the term is -numerator / denominator
        Value denominator;  // float > 0
    };
    std::vector<Term> pending;  // at most 2
};

class GradientAlgebra {
public:
    static constexpr size_t max_slots = 8;
    static constexpr size_t max_pending = 2;

    GradientAlgebra(Module& target, ScreenDerivatives& screen)
        : target_(&target), screen_(&screen) {}

    GradientSum from_slope(const FrameKey& basis, Value slope);
    // -slope / depth; the division may stay pending.
    GradientSum from_negated_slope(const FrameKey& basis, Value slope, Value depth);
    GradientSum add(GradientSum a, const GradientSum& b);
    GradientSum scale(GradientSum a, Value amount);

    // Returns Gamma, every term divided and tangent to its base; empty if it is flat. `on_base` is
    // the resolved normal of that base, empty for the surface.
    Value vector(const GradientSum& sum, Value on_base);

    // Returns normalize(n - sign * Gamma); the surface's normal is `facing` times the interpolated
    // one. An empty `facing` or `sign` is 1.
    Value resolve(const GradientSum& sum, Value facing, Value sign, Value on_base);

private:
    // Slopes in space: vec + n along.
    struct Parts {
        Value vec, along;
    };
    Slopes add(Slopes a, const Slopes& b);
    Slopes scale(Slopes a, Value amount);
    Slopes terms_over_depth(const GradientSum& sum, Value& depth);
    Parts parts(const Slopes& slopes, Value on_base, bool raw);
    void divide(GradientSum& sum);
    Value screen_gradient(Value slope);

    Module* target_;
    ScreenDerivatives* screen_;
};

}  // namespace wrinkle

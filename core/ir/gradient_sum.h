// Sum of surface gradients, stored as unevaluated parts. Part of the expansion pass.
//
//   Gamma = sum over bases (T s.x + B s.y)  +  G(hx, hy)  +  (g - n (n.g))  +  (v + n a)
//
// Parts: a 2-vector of slopes s per tangent basis; screen differentials hx, hy (G: Mikkelsen 2010,
// eq. 3); a volume gradient g; a vector v with its correction a along n. All are linear, so
// gradients are added part by part. Multiples of n are summed in one float and applied once, as in
// n - (g - n (n.g)) = n (1 + n.g) - g.
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
    Value rest;               // vec3; rest + n * along is tangent to the base
    Value along;              // float; empty if rest is

    bool empty() const { return slots.empty() && !screen && !volume && !rest; }
};

struct GradientSum {
    Slopes flat;
    struct Term {
        Slopes numerator;   // the negated slope's: the term is -numerator / denominator
        Value denominator;  // float > 0; the `depth` of from_negated_slope()
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
    // Returns -slope / depth, not divided yet. Precondition: depth > 0.
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
    // The vector vec + n * along. Normal components are separate.
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

// A surface gradient while it is being composed. Part of the expansion pass.
//
// Gamma = sum over bases (T s.x + B s.y)  +  eq. 3 of (hx, hy)  +  (g - n (n.g))  +  v + n a, held
// as its parts: a 2-vector of slopes per tangent basis, one of screen differentials, one volume
// vector, one vector v that n a makes tangent. All parts are linear, so layers add part by part.
// What is along n is gathered in one number and applied with n itself: n (1 + n.g) - g.
//
// The slope of a normal is a quotient, -xy/z of one in tangent space, (k n - v)/|k| of one in
// object space. Up to two such terms wait with their depths undivided: resolve multiplies n through
// instead, as positive factors drop out under the final normalize. With a third every term is
// divided: the product of three small depths overflows, and dividing is then cheaper. They wait
// without their minus too: n - Gamma becomes a sum.
#pragma once

#include <vector>

#include "ir/gradient_frame.h"

namespace wrinkle {

struct Slopes {
    struct Slot {
        FrameKey basis;
        Value slope;  // vec2
    };
    std::vector<Slot> slots;  // at most max_slots; more go into rest
    Value screen;             // vec2 (dh/dx, dh/dy); an empty Value is zero
    Value volume;             // vec3
    Value rest;               // vec3; with `along` times n tangent to the base
    Value along;              // float

    bool empty() const { return slots.empty() && !screen && !volume && !rest; }
};

struct GradientSum {
    Slopes flat;
    struct Term {
        Slopes over;  // to be divided by -depth: downhill
        Value depth;  // float > 0
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
    // -slope / depth, which may wait.
    GradientSum from_downhill(const FrameKey& basis, Value slope, Value depth);
    GradientSum add(GradientSum a, GradientSum b);
    GradientSum scale(GradientSum a, Value amount);

    // Gamma itself, every term divided and tangent to its base; empty for a flat one. `on_base` is
    // the resolved normal of that base, empty for the surface.
    Value vector(const GradientSum& sum, Value on_base);

    // normalize(n - sign * Gamma); the surface's normal is `facing` times the interpolated one
    // (`facing` may be empty: 1).
    Value resolve(const GradientSum& sum, Value facing, Value sign, Value on_base);

private:
    // What Slopes are in space: vec + n along.
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

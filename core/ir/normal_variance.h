// The variance of a normal within a pixel. Part of the expansion pass.
//
// docs/surface-gradient.md#roughness-of-what-mips-leave-out defines the sources and the sum over
// their Jacobians (Toksvig 2005; LEAN Mapping 2010). `with_covariance` attaches a covariance to a
// value; a normal read from a texture does not need it, because its length has the variance, which
// fades in over the first mip level. Reads of different textures, or of one at different uvs, count
// as independent.
//
// Depths that slopes are divided by count as constants, and so do weights computed from the
// position. Time is proportional to the size of the expression of the normal, for any number of
// varying values.
#pragma once

#include <optional>

#include "ir/gradient_frame.h"

namespace wrinkle {

class NormalVariance {
public:
    NormalVariance(Module& target, ScreenDerivatives& screen)
        : target_(&target), screen_(&screen) {}

    // Returns the xy of `normal`, where xy / depth is a slope; with a covariance if `normal` is
    // read from a texture. `factor` * `normal` is the mean normal that the texture represents.
    Value tangent_normal(Value normal, Value depth, double factor);
    // Returns `normal` (object space), with a covariance if it is read from a texture.
    Value object_normal(Value normal, double factor);
    // Returns `value` with a covariance: (xx, yy, xy) for a vec2; for a vec3 one variance that all
    // its components have.
    Value varying(Value value, Value covariance);

    // Returns the trace of the covariance of a normal returned by GradientAlgebra::resolve(), in
    // [0, ...).
    Value of(Value normal);
    // Returns that covariance along x and cross(normal, x): (xx, yy, xy). `x` is a unit vector
    // across the normal.
    Value along(Value normal, Value x);

private:
    std::optional<Value> variance_lost_to_filtering(Value normal, double factor);

    Module* target_;
    ScreenDerivatives* screen_;
};

// Returns true if an output needs a normal variance; otherwise the class above is not needed.
bool wants_normal_variance(const Module& source);

}  // namespace wrinkle

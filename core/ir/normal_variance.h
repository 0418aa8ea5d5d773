// The variance of a normal within a pixel. Part of the expansion pass.
//
// A minified texture returns means; the variation that they omit still scatters light: the
// covariance of the slopes. `with_covariance` attaches a covariance to a value. A normal that is
// read from a texture does not need it, because a mean of unit normals is shorter than one by their
// spread, 1 - |mean|^2 = trace Cov (Toksvig 2005), taken here as equal in all directions about the
// mean. It fades in over the first mip level: a texture that is not minified has lost nothing,
// whatever the rounding of its normals suggests.
//
// The unit normal n' = n'(s_1, s_2, ...) of all layers has, to first order, the covariance sum over
// k of J_k C_k J_k^T with J_k = dn'/ds_k by automatic differentiation (Olano and Baker, LEAN
// Mapping, 2010). Therefore an amount counts by its square, a frame as J C J^T, a mask as (1-m)^2
// C_1 + m^2 C_2, and a texture read that is used twice as the sum of its slopes; none of these
// rules is implemented separately. Reads of different textures, or of one at different uvs, count
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

private:
    std::optional<Value> variance_lost_to_filtering(Value normal, double factor);

    Module* target_;
    ScreenDerivatives* screen_;
};

// Returns true if an output needs a normal variance; otherwise the class above is not needed.
bool wants_normal_variance(const Module& source);

}  // namespace wrinkle

// How much a normal varies within a pixel. Part of the expansion pass.
//
// A picture read smaller than it is gives means, and what they leave out still scatters light: the
// covariance of the slopes. A value is said to vary by `with_covariance`; a normal that is read
// from a picture needs no word, as a mean of unit normals is shorter than one by their spread, 1 -
// |mean|^2 = trace Cov (Toksvig 2005), here the same in all directions about the mean. It fades in
// over the first level of the picture: what is read as large as it is or larger has lost nothing,
// whatever its rounding says.
//
// The unit normal n' = n'(s_1, s_2, ...) of all layers has, to first order, the covariance
// sum over k of J_k C_k J_k^T with J_k = dn'/ds_k by forward derivative (Olano and Baker, LEAN
// Mapping, 2010). So an amount counts by its square, a frame as J C J^T, a mask as (1-m)^2 C_1 +
// m^2 C_2, one read that is met twice as its slopes added first, and no rule of these is written
// anywhere. Reads of different pictures, or of one at different uvs, count as independent.
//
// Depths that slopes are divided by count as constants, and so do weights that come from the
// position. Time is the size of what the normal needs, however many values vary.
#pragma once

#include <optional>

#include "ir/gradient_frame.h"

namespace wrinkle {

class NormalVariance {
public:
    NormalVariance(Module& target, ScreenDerivatives& screen)
        : target_(&target), screen_(&screen) {}

    // `normal`, its xy divided by the depth z being a slope: xy as it varies where it is read from
    // a picture. `factor` times it is what the picture means.
    Value tangent_normal(Value normal, Value depth, double factor);
    // `normal` in object space as it varies where it is read from a picture.
    Value object_normal(Value normal, double factor);
    // A vec2 with covariance (xx, yy, xy), or a vec3 whose lanes all have one variance.
    Value varying(Value value, Value covariance);

    // The trace of the covariance of a normal made by GradientAlgebra::resolve(), in [0, ...).
    Value of(Value normal);

private:
    std::optional<Value> lost_by_reading(Value normal, double factor);

    Module* target_;
    ScreenDerivatives* screen_;
};

// Whether some output asks for it; else nothing above is needed.
bool wants_normal_variance(const Module& source);

}  // namespace wrinkle

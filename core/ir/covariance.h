// The covariance of a value, from the values in its expression that vary within a pixel
// (`with_covariance`). A module contains `with_covariance` while it is expanded, and afterwards
// only with `Covariances::kept`.
//
// To first order the covariance is the sum over sources k of J_k C_k J_k^T, J_k the Jacobian of the
// value with respect to the source (ir/jacobian_by_source.h). ir/normal_variance.h documents the
// sources.
#pragma once

#include <vector>

#include "ir/value.h"

namespace wrinkle {

// One term of the sum: weight (a b^T + b a^T) / 2.
struct CovarianceTerm {
    Value a, b, weight;
};
std::vector<CovarianceTerm> covariance_terms(Value value);

// Returns (xx, yy, xy) of a vec2; an empty Value if it has no source.
Value covariance_of(Value value);

// Returns the module with each `with_covariance` replaced by its value, as execution requires.
Module drop_covariances(Module source);

}  // namespace wrinkle

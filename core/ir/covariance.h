// The covariance of a value, from what it is made of that varies within a pixel: `with_covariance`,
// which a module holds while it is expanded, and after that where it was to be kept.
//
// To first order that is the sum over sources k of J_k C_k J_k^T, J_k the forward derivative of the
// value along the source. Where sources come from is said in ir/normal_variance.h.
#pragma once

#include <vector>

#include "ir/value.h"

namespace wrinkle {

// Of the sum of such terms: weight (a b^T + b a^T) / 2.
struct CovarianceTerm {
    Value a, b, weight;
};
std::vector<CovarianceTerm> covariance_terms(Value value);

// (xx, yy, xy) of a vec2; an empty Value where nothing varies.
Value covariance_of(Value value);

// The module without any `with_covariance`, which is what runs.
Module drop_covariances(Module source);

}  // namespace wrinkle

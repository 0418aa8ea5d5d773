// Reverse-mode derivatives (vector-Jacobian products): the Jacobians of a value with respect to all
// sources that it depends on, in one pass from the value to its operands. Time is proportional to
// the size of the expression; one ForwardDiff (forward mode) per source would take that times the
// number of sources. Part of the expansion pass.
//
// Sources are the `with_covariance` instructions; `detach` is differentiated as the identity. A
// column is d value / d one component of a source, stored as a vector times a scalar factor:
// derivatives of layers on one frame are multiples of the same vectors. ForwardDiff::local_jvp()
// provides the derivative of each single instruction.
#pragma once

#include <array>
#include <vector>

#include "ir/value.h"

namespace wrinkle {

struct SourceJacobian {
    Id source = no_id;
    std::array<Scaled, 4> columns;  // by component of the source
};

// Returns the Jacobians for the sources that `value` depends on, in increasing order of id.
std::vector<SourceJacobian> jacobians_by_source(Value value);

}  // namespace wrinkle

// How a value changes with each of many that it is made of, in one pass from it downwards (reverse
// mode): in time of the size of what it needs, where a Direction for each would take that times
// their number. Part of the expansion pass.
//
// Sources are the values that vary, `with_covariance`; what is detached is seen through. A column
// is d value / d one number of a source, held as a vector times a number: changes of layers on one
// frame are multiples of the same vectors. The derivative of each instruction by itself is
// Direction's.
#pragma once

#include <array>
#include <vector>

#include "ir/value.h"

namespace wrinkle {

// vector * factor; an empty factor is 1, an empty vector none at all.
struct Scaled {
    Value vector, factor;
};

struct SourceChange {
    Id source = poison;
    std::array<Scaled, 4> columns;  // by number of the source
};

// Of those that change it, in the order of their ids.
std::vector<SourceChange> changes_by_source(Value value);

}  // namespace wrinkle

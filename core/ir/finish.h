// The last rewriting of an expanded module: what is detached says nothing any more, nor does
// what varies where nobody asks, and a vector that is divided by its length elsewhere too is made
// unit by that quotient. Part of the expansion pass.
#pragma once

#include "ir/expand.h"

namespace wrinkle {

Module finish(Module expanded, Covariances covariances);

}  // namespace wrinkle

// Last rewrite of an expanded module: removes `detach`, removes `with_covariance` unless it is
// kept, and replaces normalize(v) by v * inversesqrt(dot(v, v)) if that factor is computed
// elsewhere too. Part of the expansion pass.
#pragma once

#include "ir/expand.h"

namespace wrinkle {

Module finish(Module expanded, Covariances covariances);

}  // namespace wrinkle

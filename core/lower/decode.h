// What the numbers of a texture mean (design: encodings), as arithmetic right after the sample.
#pragma once

#include "base/texture_options.h"
#include "ir/module.h"

namespace wrinkle {

// A vec4 as sampled -> a vec4 as meant. Alpha passes unchanged, but with normal_rg and normal_ag it
// is 1.
Id decode(Module& module, Encoding encoding, Id texel);

}  // namespace wrinkle

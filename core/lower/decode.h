// Decodes the numbers of a texture (design: encodings) by arithmetic right after the sample.
#pragma once

#include "base/texture_options.h"
#include "ir/module.h"

namespace wrinkle {

// Returns the decoded vec4 of a sampled vec4. Alpha is unchanged, except that it is 1 for normal_rg
// and normal_ag.
Id decode(Module& module, Encoding encoding, Id texel);

}  // namespace wrinkle

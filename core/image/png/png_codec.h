// The codec of PNG, by libpng. It reads every PNG: palettes and 1, 2 and 4 bits become 8 bits,
// transparent colors an alpha channel. The color space that a file declares is ignored, and alpha
// is not multiplied into the colors. It writes 8 and 16 bits, and numbers as text "Description".
#pragma once

#include "image/codec.h"

namespace wrinkle::png {

extern const WrinkleImageCodec table;

}  // namespace wrinkle::png

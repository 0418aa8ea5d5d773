// Opening the module that holds OpenImageIO, once per process, on first need; base/companion.h says
// where it is looked for.
#pragma once

#include <string>

#include "base/companion.h"
#include "image/oiio/image_module.h"

namespace wrinkle {

// The table of functions, or null with the reason in `why`; the first answer is kept.
const WrinkleImageModule* image_module(std::string& why);

}  // namespace wrinkle

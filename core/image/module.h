// Loads the module that contains OpenImageIO, once per process, on first use;
// base/dynamic_library.h documents its search path.
#pragma once

#include <string>

#include "base/dynamic_library.h"
#include "image/oiio/image_module.h"

namespace wrinkle {

// Returns the table of functions; null and the reason in `why` on failure. The first result is
// cached.
const WrinkleImageModule* image_module(std::string& why);

}  // namespace wrinkle

// Selects the codec of a format. That of PNG is part of the program; the module with OpenImageIO is
// loaded once per process, on first use of another format, because it takes 0.3 s.
// base/dynamic_library.h documents its search path.
#pragma once

#include <string>
#include <string_view>

#include "base/dynamic_library.h"
#include "image/codec.h"

namespace wrinkle {

// Returns the built-in codec for "png", and that of the module for any other name of formats.h.
// Returns null and the reason in `why` if the module cannot be loaded.
const WrinkleImageCodec* find_codec(std::string_view format, std::string& why);

}  // namespace wrinkle

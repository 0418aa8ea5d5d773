// Selects the codec of a format. That of PNG is part of the program; the module with OpenImageIO is
// loaded once per process, on first use of another format: its 260 shared libraries take 0.3 s.
// base/dynamic_library.h documents its search path.
#pragma once

#include <string>
#include <string_view>

#include "base/dynamic_library.h"
#include "image/codec.h"

namespace wrinkle {

// `format` is the name by which the codec knows it: formats.h. Returns null and the reason in `why`
// on failure.
const WrinkleImageCodec* find_codec(std::string_view format, std::string& why);

}  // namespace wrinkle

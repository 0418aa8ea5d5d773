// Finding and opening the module that holds OpenImageIO, once per process, on first need.
//
// Looked for as <folder of the running program>/../lib/wrinkle/NAME, then in each folder of the
// environment variable WRINKLE_MODULE_PATH (separated by ':').
#pragma once

#include <string>

#include "image/oiio/image_module.h"

namespace wrinkle {

// The table of functions, or null with the reason in `why`; the first answer is kept.
const WrinkleImageModule* image_module(std::string& why);

inline constexpr const char* image_module_remedy =
    "install Wrinkle's lib/wrinkle beside its bin folder, or name the folder of the module in "
    "WRINKLE_MODULE_PATH";

}  // namespace wrinkle

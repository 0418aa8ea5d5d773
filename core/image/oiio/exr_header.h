// The sizes in the header of an OpenEXR file, looked at before it is opened: OpenEXR's C++ library,
// which OpenImageIO uses, takes as much memory as they say before anybody can ask it.
//
// The C library looks as well, but it goes on where attributes are damaged, and not as the C++
// library does. Layout: openexr.com, "OpenEXR File Layout".
#pragma once

#include <cstdint>

namespace wrinkle::oiio {

struct ExrSize {
    int64_t width = 0, height = 0;  // of the largest data window
};

// Throws Failure where an attribute is larger than the rest of the file.
ExrSize size_of_exr(const char* path);

}  // namespace wrinkle::oiio
